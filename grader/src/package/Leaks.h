#pragma once

#include <string>
#include <vector>

#include "package/CourseFiles.h"

namespace grader {

/// A run of this many tokens of a solution is a leak.
inline constexpr std::size_t kLeakTokens = 20;

/// A place in a package that says what a solution's TODO region says.
struct Leak {
    std::string path;    ///< of the package's file
    std::string source;  ///< the solution's file and its region
    std::string words;   ///< the first run that was found
};

/// Looks for runs of kLeakTokens tokens of any TODO region of `secret` (the files of solutions/) in
/// all files of `package`, whatever their encoding: in code, in comments, in strings. Runs that a
/// file of `known` has, too, are no secret: starters and the framework. One finding for each file
/// and region.
std::vector<Leak> leaksOf(const CourseFiles& package, const CourseFiles& secret,
                          const CourseFiles& known);

/// Files in which a solution might hide from that search, by path: archives, and whatever else is
/// neither text nor of a kind that the course has.
std::vector<std::string> unsearchable(const CourseFiles& package);

}  // namespace grader
