#pragma once

#include <optional>
#include <string>
#include <vector>

#include "Archive.h"
#include "Manifest.h"
#include "batch/Moment.h"

namespace grader {

/// Somebody, as a learning platform calls them; what it does not tell is empty.
struct Owner {
    std::string id, name, email;
};

/// A file that lies among those of other students, and what it is called in the submission.
struct LooseFile {
    std::string name;
    fs::path path;
};

enum class EntrantKind { folder, archive, clone, looseFiles };

/// One submission of a batch.
struct Entrant {
    std::string name;  ///< unique in the batch: of the folder, or of the archive without its ending
    fs::path path;     ///< of the folder or archive
    EntrantKind kind = EntrantKind::folder;
    std::vector<LooseFile> files = {};
    std::vector<Owner> owners = {};  ///< several where a group handed it in; none: the name says
    std::optional<Moment> submitted = {};
    bool late = false;  ///< says the platform, without saying by how much
};

struct Intake {
    std::vector<Entrant> entrants;     ///< by name
    std::vector<std::string> ignored;  ///< what is no submission, with the reason
};

/// What somebody put into a folder for grading.
///
/// Either folders, git clones, archives (zip, tar, tar.gz, tgz, tar.xz, tar.bz2) and, where the
/// assignment wants one file only, files with its ending named after the students; or the export
/// of Canvas, Moodle or Gradescope as it is (Platforms.h). A folder that holds one archive and no
/// file of the assignment stands for that archive. Links are never followed. Throws Error for a
/// folder that is not there or holds no submission, and when two submissions have one name.
Intake takeIn(const fs::path& submissions, const Manifest& manifest,
              const std::vector<std::string>& knownAssignments);

/// Reads when each was handed in from a table with the columns "submission" and "submitted", and
/// whose it is where there is a column "student". Throws Error for a submission that is not there.
void addTimes(Intake& intake, const fs::path& table);

/// The name without an archive's ending; nothing when it is no archive's name.
std::optional<std::string> stemOfArchive(const std::string& name);

/// What a folder is: a git clone, an archive that it stands for, or itself.
Entrant entrantOf(const std::string& name, const fs::path& folder, const Manifest& manifest,
                  const std::vector<std::string>& knownAssignments);

/// The folder with an entrant's files: where it is, or unpacked or copied into the job's folder.
Unpacked layOut(const Toolchain& tools, const Sandbox& sandbox, const Job& job,
                const Entrant& entrant, const std::vector<std::string>& knownAssignments);

}  // namespace grader
