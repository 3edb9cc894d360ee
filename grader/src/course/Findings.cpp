#include "course/Findings.h"

#include <fmt/format.h>

#include <iostream>

namespace grader {

void Findings::add(const std::string& what, const std::string& mend) {
    ++count_;
    std::cout << fmt::format("  ✗ {}\n    mend: {}\n", what, mend) << std::flush;
}

}  // namespace grader
