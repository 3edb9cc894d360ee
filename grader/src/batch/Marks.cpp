#include "batch/Marks.h"

#include <cmath>

namespace grader {

namespace {

/// Without decisions and lateness.
Mark markFrom(const Manifest& manifest, const Participant& participant, const Standing* standing) {
    Mark mark;
    mark.student = participant.student;
    mark.sentence = participant.problem;
    mark.status = participant.problem.empty() ? "missing" : "unclear";
    std::map<std::string, double> points;
    if (standing) {
        mark.submission = standing->entrant;
        mark.status = standing->status;
        mark.sentence = standing->sentence;
        mark.result = standing->result;
        if (!standing->unstable.empty())
            mark.warnings.push_back(standing->unstable);
        if (standing->result)
            for (const Essence::Task& task : standing->result->tasks)
                points[std::string(task.id)] = task.points;
    }
    const bool judged = mark.status == "graded" || mark.status == "build_error";
    for (const Task& task : manifest.tasks) {
        mark.tasks.push_back(
            {task.id, points[task.id], points[task.id], task.points, task.manual && judged, ""});
        mark.automatic += points[task.id];
        mark.maxPoints += task.points;
    }
    mark.automatic = rounded(mark.automatic);
    return mark;
}

void decide(Mark& mark, const Overrides& overrides) {
    std::size_t decided = 0;
    for (TaskMark& task : mark.tasks)
        if (const Override* decision = overrides.find(mark.student.id, task.id)) {
            ++decided;
            task.points = decision->points;
            task.pending = false;
            task.reason = decision->reason;
        }
    // What a person decided is a mark of its own where there is nothing to grade. A fault of the
    // grader's, or not knowing what to grade, stays one until every task is decided.
    const bool nothingToGrade = mark.status == "missing" || mark.status == "refused";
    const bool all = decided == mark.tasks.size() && !mark.sentence.empty();
    if (decided > 0 && (nothingToGrade || all)) {
        mark.status = "decided";
        mark.sentence.clear();
    }
}

/// Warns where the automatic mark under a decision is another than it was.
void remind(Mark& mark, Overrides& overrides) {
    for (const TaskMark& task : mark.tasks) {
        const Override* decision = overrides.find(mark.student.id, task.id);
        if (!decision)
            continue;
        const double before = overrides.automaticWhenDecided(*decision, task.automatic);
        if (std::abs(before - task.automatic) > 1e-6)
            mark.warnings.push_back(fmt::format(
                "{}: the automatic mark was {:g} when it was decided, and is {:g} now: look again, "
                "and change the reason to confirm",
                task.id, before, task.automatic));
    }
}

void charge(Mark& mark, const Entrant* entrant, const Policy& policy) {
    double sum = 0;
    for (const TaskMark& task : mark.tasks)
        sum += task.points;
    if (entrant)
        mark.lateness = latenessOf(mark.student, *entrant, policy);
    mark.points = rounded(sum * (1 - mark.lateness.percent / 100));
}

}  // namespace

std::vector<std::string> Mark::remarks() const {
    std::vector<std::string> all;
    for (const TaskMark& task : tasks)
        if (!task.reason.empty())
            all.push_back(
                fmt::format("{}: {:g} of {:g} points by a person's decision, in place of "
                            "{:g}: {}",
                            task.id, task.points, task.maxPoints, task.automatic, task.reason));
    if (!lateness.says.empty())
        all.push_back(lateness.says);
    return all;
}

Json jsonOf(const Mark& mark) {
    Json tasks = Json::array();
    for (const TaskMark& task : mark.tasks) {
        tasks.push_back({{"id", task.id}, {"points", task.points}, {"max_points", task.maxPoints}});
        if (task.pending)
            tasks.back()["pending"] = true;
        if (!task.reason.empty()) {
            tasks.back()["automatic"] = task.automatic;
            tasks.back()["reason"] = task.reason;
        }
    }
    Json json = {{"student", mark.student.id},    {"name", mark.student.name},
                 {"email", mark.student.email},   {"section", mark.student.section},
                 {"submission", mark.submission}, {"status", mark.status},
                 {"points", mark.points},         {"automatic", mark.automatic},
                 {"max_points", mark.maxPoints},  {"sentence", mark.sentence},
                 {"remarks", mark.remarks()},     {"tasks", tasks},
                 {"warnings", mark.warnings}};
    if (mark.lateness.late)
        json["late"] = {{"days", mark.lateness.days},
                        {"percent", mark.lateness.percent},
                        {"says", mark.lateness.says}};
    return json;
}

Mark markFrom(const Json& json) {
    Mark mark;
    mark.student.id = json.at("student");
    mark.student.name = json.at("name");
    mark.student.email = json.at("email");
    mark.student.section = json.at("section");
    mark.submission = json.at("submission");
    mark.status = json.at("status");
    mark.points = json.at("points");
    mark.automatic = json.at("automatic");
    mark.maxPoints = json.at("max_points");
    mark.sentence = json.at("sentence");
    mark.warnings = json.at("warnings").get<std::vector<std::string>>();
    for (const Json& task : json.at("tasks")) {
        const double points = task.at("points");
        mark.tasks.push_back({task.at("id"), task.value("automatic", points), points,
                              task.at("max_points"), task.value("pending", false),
                              task.value("reason", "")});
    }
    if (json.contains("late"))
        mark.lateness = {true, json.at("late").at("days"), json.at("late").at("percent"),
                         json.at("late").at("says")};
    return mark;
}

std::vector<Mark> marksOf(const Manifest& manifest, const ClassList& list,
                          const std::map<std::string, Standing>& standings, AttemptRule rule,
                          const Policy& policy, Overrides& overrides) {
    std::vector<Mark> marks;
    for (const Participant& participant : list.participants) {
        std::optional<Mark> best;
        const auto attempts = attemptsToGrade(participant, rule, policy);
        bool all = true;
        for (const Entrant* entrant : attempts) {
            const auto standing = standings.find(entrant->name);
            all = all && standing != standings.end();
            if (!all)
                break;
            Mark mark = markFrom(manifest, participant, &standing->second);
            decide(mark, overrides);
            charge(mark, entrant, policy);
            // The later one, where two earn alike. What the grader failed at might be the best.
            const auto failed = [](const Mark& each) { return each.status == "grader_error"; };
            if (!best || failed(mark) || (!failed(*best) && mark.points >= best->points))
                best = std::move(mark);
        }
        if (!all)
            continue;
        if (!best) {
            best = markFrom(manifest, participant, nullptr);
            decide(*best, overrides);
            charge(*best, nullptr, policy);
        }
        remind(*best, overrides);
        marks.push_back(std::move(*best));
    }
    return marks;
}

}  // namespace grader
