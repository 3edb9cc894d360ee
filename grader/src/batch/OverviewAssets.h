#pragma once

#include <string_view>

namespace grader {

/// The files of the same names in grader/src/batch/, as they were when this was built.
extern const std::string_view kOverviewStyle;   ///< overview.css
extern const std::string_view kOverviewScript;  ///< overview.js

}  // namespace grader
