#pragma once

#include "batch/Intake.h"

namespace grader {

/// A student of the roster.
struct Student {
    std::string id, name, email, section, group;
    std::optional<Moment> due;          ///< in place of the policy's
    std::chrono::seconds extension{0};  ///< on top of either
};

/// Reads a table with the column "id" and any of name, email, section, group, due (a time), and
/// extension ("2d", "12h", or the time that the deadline is moved to, as "due" has it). Throws
/// Error for an id that is missing or there twice.
std::vector<Student> readRoster(const fs::path& file);

/// One student with all that they handed in.
struct Participant {
    Student student;
    bool inRoster = false;
    std::vector<const Entrant*> attempts = {};  ///< the earliest first; none: nothing handed in
    std::string problem = {};  ///< why none of them can be graded; empty when one can
};

struct ClassList {
    std::vector<Participant> participants;  ///< by id
    std::vector<std::string> unclear;       ///< submissions that could be several students'
};

/// Who is who. A submission belongs to the student of the roster whose id or email it names, or
/// whose name, where only one has it; to all of a group where it names that. Nothing is guessed:
/// one that fits several students is nobody's and listed, and one that fits none stands for
/// itself, as every submission does without a roster (null). Keeps pointers into `intake`.
ClassList whoIsWho(const Intake& intake, const std::vector<Student>* roster);

}  // namespace grader
