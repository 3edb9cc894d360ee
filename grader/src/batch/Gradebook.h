#pragma once

#include "batch/Csv.h"

namespace grader {

/// One student's line for a platform's table.
struct Line {
    std::string id, name, email;
    double points = 0, maxPoints = 0;
    std::string feedback;
};

/// What came of filling in a table.
struct Filled {
    std::string text;                  ///< of the table: every other byte as it was
    std::size_t marks = 0;             ///< that were filled in
    std::vector<std::string> remarks;  ///< students that are not in it, marks that may not change
};

/// Fills a gradebook that Canvas exported: the column of that name, or the one that has it in its
/// name. Where Canvas counts another number of points than we do, marks are scaled, and that is
/// said. Throws Error for a file that is no such table.
Filled fillCanvas(CsvTable table, const std::string& column, const std::vector<Line>& lines);

/// Fills an offline grading worksheet that Moodle exported: grade and feedback. Participants are
/// found by the number behind "Participant", by email address, or by full name where one has it.
Filled fillMoodle(CsvTable table, const std::vector<Line>& lines);

}  // namespace grader
