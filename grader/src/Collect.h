#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "Diagnostics.h"
#include "Manifest.h"

namespace grader {

/// Bytes of a file that is taken, at most.
inline constexpr std::uintmax_t kLargestFile = 4u << 20;

/// Where a submission is. Either `folder` holds one folder per assignment, or it is the folder of
/// one assignment's files.
struct Submission {
    fs::path folder;
    bool perAssignment = true;

    /// Its folder for the assignment that is graded; it need not exist.
    fs::path folderFor(const std::string& assignment) const;

    /// Where it may have a file that the assignment takes, the first choice first: in its folder
    /// for this assignment; an inherited one in its folder for the named one. What belongs in a
    /// subfolder (shaders/lighting.frag) may lie above it, for platforms hand in files without
    /// folders.
    std::vector<fs::path> placesOf(const Manifest& manifest, const std::string& name) const;
    /// The first of these where there is something.
    std::optional<fs::path> placeOf(const Manifest& manifest, const std::string& name) const;

    /// Whether a path is a link, or leads through one, below `folder`: it may lead anywhere.
    bool isBehindLink(const fs::path& path) const;
    /// What is in one of its folders, sorted; nothing behind a link, or where it cannot be read.
    std::vector<fs::path> entriesOf(const fs::path& path) const;
};

/// What a folder is: with a folder named like one of the `known` assignments it holds one for each,
/// and so does a copy of the course, in its assignments/. Links are not followed.
Submission submissionIn(const fs::path& folder, const std::vector<std::string>& known);

/// Whose file it is in the stage.
enum class Role {
    own,        ///< the student's file of this assignment
    inherited,  ///< the student's file of an earlier one
    provided,   ///< the assignment's own: scene, harness, shaders
};

struct StagedFile {
    std::string name;  ///< relative to the stage
    Role role;
    std::string origin;  ///< "submission", "solutions", "starter", "assignment"
    std::string content;
};

/// A clean copy of the assignment with the submission's files laid over it.
struct Stage {
    std::vector<StagedFile> files;
    /// Inherited headers as the course has them. A solution that stands in for an inherited file is
    /// compiled with these and what is provided: no text of the submission's ever sees it.
    std::vector<StagedFile> coursesHeaders;

    StagedFile* find(const std::string& name);
    const StagedFile* find(const std::string& name) const;
};

struct Collected {
    Stage stage;
    std::vector<std::string> ignored;  ///< files and folders (with a slash) not taken
    std::vector<std::string> notices;
    std::vector<Diagnostic> unreadable;  ///< files that cannot be taken as they are
};

/// Tasks of an assignment that have a region in a file's text.
std::vector<std::string> tasksIn(const Manifest& manifest, const std::string& text);

/// What students hand in for an assignment, and what they begin with (name → starter): `submit`;
/// and where a task is solved in a file of an earlier assignment, that one's files
/// (08-perspective: Camera.h and Camera.cpp of 07-camera).
std::map<std::string, fs::path> handedIn(const Manifest& manifest);
/// What is said where one of them is missing in the course itself: how to have it back.
std::string missingStarter(const std::string& assignment, const std::string& name);
/// Whether one of them is called so, in whichever folder it belongs.
bool hasFileNamed(const std::map<std::string, fs::path>& handedIn, const std::string& name);

/// What takes the place of an inherited file that is missing or broken: the solution's, in which
/// the tasks of the assignment itself are as the starter has them; or the starter's where there are
/// no solutions.
StagedFile substituteFor(const fs::path& root, const Manifest& manifest, const std::string& name);

bool isHeader(const std::string& name);

/// Whether the solution or the starter takes this inherited file's place when it takes that of
/// `source`: headers go with their assignment's sources, or classes would not fit.
bool goesWith(const Manifest& manifest, const std::string& header, const std::string& source);

/// Takes the files that the manifest lists and nothing else.
///
/// Files are where Submission::placeOf() finds them. A missing one is named and replaced by the
/// starter's; an inherited one by substituteFor(), and so are the headers of a source that is. A
/// byte-order mark and carriage returns are taken out; a file that is not UTF-8 or cannot be read,
/// or is missing where the starter itself is the submission, is reported in `unreadable`.
Collected collect(const fs::path& root, const Manifest& manifest, const Submission& submission);

}  // namespace grader
