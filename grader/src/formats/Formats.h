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
    Json result;      ///< the result document, grader/RESULT.md; at least `assignment`
    fs::path report;  ///< where the pictures of the document are; may be empty
};

/// results.json of a Gradescope autograder, below a megabyte. A check is shown when the manifest
/// says so; pictures of lost frames are embedded as long as there is room.
std::string gradescopeResult(const Scored& scored);

/// The one that gives no mark, and tells the student that it is not their fault.
std::string gradescopeFault();

/// results.json of a PrairieLearn external grader, below the megabyte that is allowed, with
/// pictures as above. Code that does not compile is not gradable there: it costs no attempt.
/// PrairieLearn shows all that it is given, so only checks that are always visible are in it.
std::string prairieLearnResult(const Scored& scored);

/// The one that gives no mark and takes no attempt.
std::string prairieLearnFault();

/// What only the instructor of a Classroom 50 course knows.
struct Classroom {
    std::string name, datetime;
};
/// Version 1 of classroom50/result, whose points are whole numbers.
std::string classroom50Result(const Scored& scored, const Classroom& classroom);

/// The last line that an Autolab autograder prints: points by task. What being late costs is
/// Autolab's own to charge.
std::string autolabLine(const Scored& scored);

/// What it prints where there is no mark: no line of scores, which Autolab reports as an error.
std::string autolabFault();

/// JUnit XML: a test suite for each submission, a test case for each check.
std::string junitXml(const std::string& name, const std::vector<Scored>& all);

}  // namespace grader
