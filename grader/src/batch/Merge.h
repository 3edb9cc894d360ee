#pragma once

#include "batch/Overview.h"

namespace grader {

/// What several batches of one class found, put together.
struct Merged {
    std::string assignment;
    std::uint64_t seed = 0;
    Json environment;
    std::vector<Mark> marks;  ///< by student
    std::vector<std::string> classIds, notTaken;
    std::vector<std::string> missing;       ///< students of the class that no part has graded
    std::map<std::string, fs::path> parts;  ///< submission → the part that has its folders
};

/// Reads the results of parts, in any order; a part may be given twice. What two parts have must
/// agree. Throws Error when it does not, when the parts are of different assignments or seeds, or
/// when one has no results.json. Different compilers or processors are said in `notTaken`.
Merged readParts(const std::vector<fs::path>& parts);

/// Copies the folders of the merged students into `out`, where they are not yet.
void copyFolders(const Merged& merged, const fs::path& out);

}  // namespace grader
