#pragma once

#include <fmt/format.h>

#include <stdexcept>

namespace grader {

/// The grader's own failure, or a wrong use of it: caught in main only, exit code 2. The text says
/// what was expected, what was found and what to do next. A student's failure is data, not this.
struct Error : std::runtime_error {
    template <class... A>
    explicit Error(fmt::format_string<A...> format, A&&... arguments)
        : std::runtime_error(fmt::format(format, std::forward<A>(arguments)...)) {}
};

}  // namespace grader
