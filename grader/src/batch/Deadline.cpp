#include "batch/Deadline.h"

#include <algorithm>
#include <cmath>

#include "Error.h"
#include "Fields.h"

namespace grader {

Policy Policy::load(const fs::path& file) {
    const Json json = parseJsonFile(file.string());
    Fields fields(json, file.string());
    if (const int format = fields.get<int>("format"); format != 1)
        throw Error("{}: format {} is not known, only 1", file.string(), format);
    Policy policy;
    if (const auto due = fields.get<std::string>("due", ""); !due.empty())
        policy.due = parseMoment(due, file.string() + ": due");
    Fields late = fields.object("late");
    policy.freeDays = late.get<double>("free_days", 0);
    policy.percentPerDay = late.get<double>("percent_per_day", 0);
    policy.capPercent = late.get<double>("cap_percent", 100);
    late.done();
    fields.done();
    for (const auto& [name, value] : {std::pair{"free_days", policy.freeDays},
                                      std::pair{"percent_per_day", policy.percentPerDay},
                                      std::pair{"cap_percent", policy.capPercent}})
        if (value < 0)
            throw Error("{}: late: {} must not be negative, found {:g}", file.string(), name,
                        value);
    if (policy.capPercent > 100)
        throw Error("{}: late: cap_percent must be at most 100, found {:g}", file.string(),
                    policy.capPercent);
    return policy;
}

std::optional<Moment> dueOf(const Student& student, const Policy& policy) {
    auto due = student.due ? student.due : policy.due;
    if (due)
        *due += student.extension;
    return due;
}

Lateness latenessOf(const Student& student, const Entrant& entrant, const Policy& policy) {
    Lateness lateness;
    const auto due = dueOf(student, policy);
    if (!entrant.submitted || !due) {
        lateness.late = entrant.late;
        if (entrant.late)
            lateness.says =
                "late, says the platform; by how much is not known here, so nothing is taken away";
        return lateness;
    }
    if (*entrant.submitted <= *due)
        return lateness;
    constexpr double kDay = 24 * 60 * 60;
    lateness.late = true;
    const double late = static_cast<double>((*entrant.submitted - *due).count());
    lateness.days = static_cast<int>(std::ceil(late / kDay));
    lateness.percent = std::clamp(std::ceil(late / kDay - policy.freeDays) * policy.percentPerDay,
                                  0.0, policy.capPercent);
    lateness.says = fmt::format(
        "{} {} late (due {}, handed in {}){}", lateness.days, lateness.days == 1 ? "day" : "days",
        toString(*due), toString(*entrant.submitted),
        lateness.percent > 0 ? fmt::format(": {:g} % of the points taken away", lateness.percent)
                             : ": nothing is taken away");
    return lateness;
}

std::vector<const Entrant*> attemptsToGrade(const Participant& participant, AttemptRule rule,
                                            const Policy& policy) {
    const auto& attempts = participant.attempts;
    if (attempts.empty() || !participant.problem.empty())
        return {};
    if (rule == AttemptRule::best)
        return attempts;
    if (rule == AttemptRule::last)
        return {attempts.back()};
    const auto inTime = std::find_if(attempts.rbegin(), attempts.rend(), [&](const Entrant* each) {
        return !latenessOf(participant.student, *each, policy).late;
    });
    return {inTime == attempts.rend() ? attempts.front() : *inTime};
}

}  // namespace grader
