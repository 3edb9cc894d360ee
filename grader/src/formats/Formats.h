#pragma once

#include <map>
#include <string>
#include <vector>

#include "Fields.h"
#include "Files.h"

namespace grader {

/// One graded submission, for a platform that shows results.
struct Scored {
    std::string student;
    double points = 0, maxPoints = 0;     ///< after decisions of people and lateness
    std::map<std::string, double> tasks;  ///< id → points, after decisions of people
    std::vector<std::string> remarks;     ///< on those; sentences
    Json result;                          ///< the result document, grader/RESULT.md; null: no file
    fs::path report;                      ///< where the pictures of the document are; may be empty
};

/// results.json of a Gradescope autograder.
std::string gradescopeResult(const Scored& scored);

/// results.json of a PrairieLearn external grader. Pictures of lost frames are embedded as long as
/// all of it stays below the megabyte that is allowed.
std::string prairieLearnResult(const Scored& scored);

/// What only the instructor of a Classroom 50 course knows.
struct Classroom {
    std::string name, datetime;
};
/// Version 1 of classroom50/result, whose points are whole numbers.
std::string classroom50Result(const Scored& scored, const Classroom& classroom);

/// The last line that an Autolab autograder prints: points by task. What being late costs is
/// Autolab's own to charge.
std::string autolabLine(const Scored& scored);

/// JUnit XML: a test suite for each submission, a test case for each check.
std::string junitXml(const std::string& name, const std::vector<Scored>& all);

}  // namespace grader
