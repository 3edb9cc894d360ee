#include "batch/Overview.h"

#include "batch/Csv.h"

namespace grader {

namespace {

Json jsonOf(const Mark& mark) {
    Json tasks = Json::array();
    for (const TaskMark& task : mark.tasks) {
        tasks.push_back({{"id", task.id}, {"points", task.points}, {"max_points", task.maxPoints}});
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
                 {"remarks", mark.remarks()},     {"tasks", tasks}};
    if (mark.lateness.late)
        json["late"] = {{"days", mark.lateness.days}, {"percent", mark.lateness.percent}};
    if (!mark.warnings.empty())
        json["warnings"] = mark.warnings;
    return json;
}

}  // namespace

std::string Overview::json() const {
    Json document = {{"format", 1},
                     {"assignment", manifest.id},
                     {"seed", seed},
                     {"environment", {{"sandbox", sandbox}, {"compiler", compiler}, {"cpu", cpu}}},
                     {"not_taken", notTaken},
                     {"alike", Json::array()},
                     {"students", Json::array()}};
    for (const Likeness& each : likenesses)
        document["alike"].push_back({{"submissions", {each.first, each.second}},
                                     {"share", each.share},
                                     {"identical", each.identical}});
    for (const Mark& each : marks)
        document["students"].push_back(jsonOf(each));
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string Overview::csv() const {
    std::string text = "student,name,section,submission,status,points,max_points,days_late";
    for (const Task& task : manifest.tasks)
        text += "," + csvCell(task.id);
    text += ",sentence,remarks\r\n";
    for (const Mark& each : marks) {
        text += fmt::format("{},{},{},{},{},{:.2f},{:.2f},{}", csvCell(each.student.id),
                            csvCell(each.student.name), csvCell(each.student.section),
                            csvCell(each.submission), each.status, each.points, each.maxPoints,
                            each.lateness.days);
        for (const TaskMark& task : each.tasks)
            text += fmt::format(",{:.2f}", task.points);
        text += fmt::format(",{},{}\r\n", csvCell(each.sentence),
                            csvCell(fmt::format("{}", fmt::join(each.remarks(), " | "))));
    }
    return text;
}

}  // namespace grader
