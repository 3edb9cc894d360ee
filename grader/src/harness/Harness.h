#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "Files.h"

namespace grader {

/// What a learning platform's machine is asked to grade.
struct PlatformRun {
    std::string platform;  ///< one of platformNames()
    std::string assignment;
    std::uint64_t seed = 1;
    std::string context = "auto";  ///< as Renderer has it
    bool noSandbox = false;
};

/// "gradescope", "prairielearn", "autolab"
const std::vector<std::string>& platformNames();

/// Grades the one submission that a platform has laid out on its machine, and puts the result where
/// and in the form that the platform reads it (docs/platforms.md):
///
/// | platform     | the submission         | the result                                       |
/// |--------------|------------------------|--------------------------------------------------|
/// | gradescope   | /autograder/submission | /autograder/results/results.json                 |
/// | prairielearn | /grade/student         | /grade/results/results.json                      |
/// | autolab      | ./handin               | standard output, the points in its last line     |
///
/// `root` takes the place of / and of the working folder. Returns true once there is a mark. A
/// fault of the grader's, whatever it is, gives the platform's form of "no mark", tells the student
/// that it is not theirs, and says why on standard error, which is the instructor's. Throws only
/// where even that cannot be written.
bool gradeForPlatform(const PlatformRun& run, const fs::path& root = {});

}  // namespace grader
