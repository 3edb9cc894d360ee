#pragma once

#include <string>
#include <vector>

#include "Manifest.h"

namespace grader {

/// One submission of a batch: a folder, or an archive.
struct Entrant {
    std::string name;  ///< of the folder, or of the archive without its ending
    fs::path path;
    bool isArchive = false;
};

struct Intake {
    std::vector<Entrant> entrants;     ///< by name
    std::vector<std::string> ignored;  ///< what is neither, with the reason
};

/// What somebody put into a folder for grading: folders, and archives (zip, tar, tar.gz, tgz,
/// tar.xz, tar.bz2). A folder that holds one archive and no file of the assignment, as learning
/// platforms make them, stands for that archive. Links are never followed. Throws Error for a
/// folder that is not there or holds no submission, and when two submissions have one name.
Intake takeIn(const fs::path& submissions, const Manifest& manifest,
              const std::vector<std::string>& knownAssignments);

}  // namespace grader
