#pragma once

#include <set>
#include <string>
#include <vector>

#include "Collect.h"
#include "Result.h"

namespace grader {

/// A wrong but plausible body of one TODO region, from solutions/NN-name/mistakes.json.
struct Mistake {
    std::string id, region, file;
    std::string says;     ///< to a student who made it, one sentence
    std::string common;   ///< what it has in common with those that look the same; may be empty
    std::string section;  ///< of the notes, to read again
    std::string body;     ///< mistakes/ID.cpp, or .vert, .frag as `file` has it
    std::string second;   ///< the same mistake written by other means; empty where there is none
    std::set<std::string> loses;  ///< ids of the tasks that lose points
    bool earnsNothing = false;    ///< identity, zero, a constant: no point in its own task

    std::string fileName() const;  ///< of its body: the id with the ending of `file`
};

/// All mistakes of a solution's folder. Throws Error that names file and field.
std::vector<Mistake> readMistakes(const fs::path& solution);

/// The solution's stage with a mistake's body (`body`, or `second`) in its region. Throws Error
/// when the file has no such region.
Stage stageWith(Stage solution, const Mistake& mistake, const std::string& body);

/// Right programs that are written otherwise (and some that lose in the tasks of their loses.json):
/// the folders in variants/ of a solution's folder, by name.
std::vector<fs::path> variantsOf(const fs::path& solution);

/// Lays the files of a folder over a stage: other versions of what a student hands in. Throws Error
/// for one that no student hands in; loses.json is left out.
void layOver(Stage& stage, const fs::path& folder);

/// What a mistake loses and its entry does not say, or the other way round; one sentence each.
std::vector<std::string> unexpectedLosses(const Mistake& mistake,
                                          const std::vector<CheckResult>& checks);

}  // namespace grader
