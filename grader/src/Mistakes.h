#pragma once

#include <set>
#include <string>
#include <vector>

#include "Result.h"

namespace grader {

/// A wrong but plausible body of one TODO region, from solutions/NN-name/mistakes.json.
struct Mistake {
    std::string id, region, file;
    std::string says;     ///< to a student who made it, one sentence
    std::string section;  ///< of the notes, to read again
    std::string body;     ///< mistakes/ID.cpp, or .vert, .frag as `file` has it
    std::string second;   ///< the same mistake written by other means; empty where there is none
    std::set<std::string> loses;  ///< ids of the tasks that lose points
};

/// All mistakes of a solution's folder. Throws Error that names file and field.
std::vector<Mistake> readMistakes(const fs::path& solution);

/// What a mistake loses and its entry does not say, or the other way round; one sentence each.
std::vector<std::string> unexpectedLosses(const Mistake& mistake,
                                          const std::vector<CheckResult>& checks);

}  // namespace grader
