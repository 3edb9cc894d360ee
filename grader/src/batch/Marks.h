#pragma once

#include "batch/Batch.h"
#include "batch/Deadline.h"
#include "batch/Overrides.h"

namespace grader {

struct TaskMark {
    std::string id;
    double automatic = 0, points = 0, maxPoints = 0;
    bool pending = false;  ///< manual, and nobody has decided yet
    std::string reason;    ///< of a person who decided otherwise; empty when nobody did
};

/// What one student gets, and why.
struct Mark {
    Student student;
    std::string submission;  ///< the entrant that counts; empty when there is none
    std::string status;      ///< of its Standing; "missing" or "unclear" without one; "decided"
                             ///< where only people gave points
    std::string sentence;    ///< why there is no automatic mark; empty when there is one
    std::vector<TaskMark> tasks;
    double automatic = 0;  ///< points, before what people decided and what being late costs
    double points = 0, maxPoints = 0;
    Lateness lateness;
    std::vector<std::string> warnings;      ///< for the instructor
    std::shared_ptr<const Essence> result;  ///< see Standing

    bool graderFailed() const { return status == "grader_error"; }
    /// The sentences that a student gets beside the report: late, decided by a person.
    std::vector<std::string> remarks() const;
};

/// As grader/RESULT.md describes a student of results.json, and back. The result document is not
/// part of it.
Json jsonOf(const Mark& mark);
Mark markFrom(const Json& json);

/// Of several submissions the rule's choice; decisions of people take the place of automatic
/// points; then being late is charged. Participants whose submissions were not all graded (the
/// batch was stopped) are left out. `standings`: by the entrant's name.
std::vector<Mark> marksOf(const Manifest& manifest, const ClassList& list,
                          const std::map<std::string, Standing>& standings, AttemptRule rule,
                          const Policy& policy, Overrides& overrides);

}  // namespace grader
