#pragma once

#include "batch/Intake.h"

namespace grader {

/// The export of a learning platform, where the folder is one:
///  - Canvas: files named NAME[_LATE]_USER_ATTACHMENT_FILE, all in one folder; the newest of a name
///    counts, and the -1 that Canvas puts behind the name of a second one is taken away;
///  - Moodle: folders NAME_PARTICIPANT_assignsubmission_file_, or files whose names begin so;
///  - Gradescope: folders submission_ID beside submission_metadata.yml, which says whose and when.
/// Nothing for any other folder. Throws Error for a metadata file that cannot be read.
std::optional<Intake> takeInExport(const fs::path& submissions, const Manifest& manifest,
                                   const std::vector<std::string>& knownAssignments);

}  // namespace grader
