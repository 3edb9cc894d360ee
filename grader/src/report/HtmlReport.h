#pragma once

#include <set>
#include <string>
#include <vector>

#include "Result.h"

namespace grader {

/// Writes the pictures of all frames and the masks of their features below `folder`, and notes the
/// paths of the pictures, relative to it, in the checks. Loads the image library.
void writeReportPictures(std::vector<AssignmentResult>& results, const fs::path& folder);

/// Takes the pictures that writeReportPictures has put into `from` over to `to`: all of them of the
/// frames that are `open`, of the others only the submission's own, for reports that must not give
/// away what seeded frames should look like.
void copyPictures(std::vector<AssignmentResult>& results, const std::set<std::string>& open,
                  const fs::path& from, const fs::path& to);

/// The report as one page that needs nothing else: pictures, style and script are embedded, and its
/// content security policy forbids everything from elsewhere. Without scripts it still shows all
/// but the tools to compare pictures with. `folder` is where writeReportPictures put the pictures.
/// With a `version` the page loads itself anew when it finds another, see LiveReport.h; to look, it
/// may show pictures from files.
std::string htmlReport(const std::vector<AssignmentResult>& results, const fs::path& folder,
                       const std::string& version = "");

/// Both: the pictures, and the page as index.html beside them.
void writeReport(std::vector<AssignmentResult>& results, const fs::path& folder);

}  // namespace grader
