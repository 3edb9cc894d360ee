#pragma once

#include <stdexcept>

namespace cg {

/// The one exception type of this library. Its text says what was expected, what was found and
/// what to do next, and names the file when there is one.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace cg
