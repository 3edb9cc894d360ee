#pragma once

#include <string>
#include <vector>

#include "batch/Batch.h"

namespace grader {

/// A batch for those who read it. `ignored`: what was in the folder and is no submission.
struct Overview {
    const Manifest& manifest;
    const std::vector<Standing>& standings;
    const std::vector<std::string>& ignored;
    std::uint64_t seed;
    std::string sandbox;

    std::string json() const;  ///< as grader/RESULT.md describes it
    std::string csv() const;   ///< RFC 4180; a row for each student, a column for each task
    /// One page that needs nothing else: grader's faults and refused archives on top, then a table
    /// to sort and to filter, each row with a link to the student's report.
    std::string html() const;
};

}  // namespace grader
