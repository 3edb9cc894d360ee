#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "Files.h"

namespace grader {

struct CourseFile {
    std::string content;
    bool executable = false;
};

/// What packages are made of: the course as its repository has it, or a part of it, by path
/// relative to the top ("assignments/06-rotation/README.md"). Same files, same package: times are
/// those of the commit, the order is the paths'.
struct CourseFiles {
    std::map<std::string, CourseFile> files;
    std::int64_t seconds = 0;  ///< since 1970, UTC: when the commit was made
    std::string commit;        ///< 40 hexadecimal digits

    /// Removes `path`, or all that is below it.
    void remove(const std::string& path);
};

/// The files that git keeps below `root`, as they are at HEAD, without those that have the
/// attribute `without` in .gitattributes (none when it is empty). Throws Error where `root` is no
/// repository, where a kept file has changes that are not committed, and where a folder of the
/// course has a new file that git does not keep: a package can be made again from its commit.
CourseFiles committedFiles(const fs::path& root, const std::string& without = "");

/// Writes them below `folder`, which must be empty or absent and not be named like an archive; else
/// throws Error.
void writeTree(const CourseFiles& course, const fs::path& folder);

/// Writes them into a zip or a tar file, by its name's end (.zip, .tar); makes the folders that are
/// missing. Throws Error for another end, or when it cannot be written; then there is no
/// half-written file.
void writeArchive(const CourseFiles& course, const fs::path& archive);

}  // namespace grader
