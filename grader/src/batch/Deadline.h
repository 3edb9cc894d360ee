#pragma once

#include "batch/Roster.h"

namespace grader {

/// What being late costs.
struct Policy {
    std::optional<Moment> due;
    double freeDays = 0;       ///< that cost nothing
    double percentPerDay = 0;  ///< of the points earned, for each day that has begun after those
    double capPercent = 100;   ///< at most

    /// {"format": 1, "due": TIME, "late": {"free_days", "percent_per_day", "cap_percent"}}, all but
    /// the format may be missing. Throws Error for anything else.
    static Policy load(const fs::path& file);
};

struct Lateness {
    bool late = false;
    int days = 0;        ///< that have begun since the deadline; 0 when it is not known
    double percent = 0;  ///< taken away
    std::string says;    ///< one sentence; empty when in time or when there is no deadline
};

std::optional<Moment> dueOf(const Student& student, const Policy& policy);
Lateness latenessOf(const Student& student, const Entrant& entrant, const Policy& policy);

/// Which of several submissions counts: the last, the last in time (the first where none is), or
/// the one with most points after what being late costs.
enum class AttemptRule { last, onTime, best };

/// The submissions of a participant that have to be graded; only the rule "best" asks for several.
std::vector<const Entrant*> attemptsToGrade(const Participant& participant, AttemptRule rule,
                                            const Policy& policy);

}  // namespace grader
