#pragma once

#include <string>
#include <vector>

#include "Result.h"

namespace grader {

/// Writes the pictures of all frames below `folder` and notes their paths, relative to it, in the
/// checks. Loads the image library.
void writeReportPictures(std::vector<AssignmentResult>& results, const fs::path& folder);

/// The report as one page that needs nothing else: pictures are embedded, there is no script and
/// no network. `folder` is where writeReportPictures put the pictures.
std::string htmlReport(const std::vector<AssignmentResult>& results, const fs::path& folder);

}  // namespace grader
