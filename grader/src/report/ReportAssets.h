#pragma once

#include <string_view>

namespace grader {

/// The files of the same names in grader/src/report/, as they were when this was built.
extern const std::string_view kReportStyle;   ///< report.css
extern const std::string_view kReportScript;  ///< pictures.js, report.js and follow.js
extern const std::string_view kReportViewer;  ///< viewer.html

}  // namespace grader
