#include "batch/Overview.h"

#include "batch/Csv.h"

namespace grader {

std::string Overview::json() const {
    Json document = {{"format", 1},
                     {"assignment", manifest.id},
                     {"seed", seed},
                     {"environment", environment},
                     {"class", classIds},
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
            text += task.pending ? ",pending" : fmt::format(",{:.2f}", task.points);
        text += fmt::format(",{},{}\r\n", csvCell(each.sentence),
                            csvCell(fmt::format("{}", fmt::join(each.remarks(), " | "))));
    }
    return text;
}

std::vector<Likeness> likenessesAmong(const Ledger& ledger, const std::vector<Mark>& marks,
                                      const std::vector<Print>& earlier) {
    std::map<std::string, Print> prints;
    for (const Mark& each : marks)
        if (auto print = each.submission.empty() ? std::nullopt : ledger.print(each.submission))
            prints.emplace(each.submission, std::move(*print));
    std::vector<Print> all;
    for (auto& [name, print] : prints)
        all.push_back(std::move(print));
    const std::size_t ours = all.size();
    all.insert(all.end(), earlier.begin(), earlier.end());
    return nearlyIdentical(all, ours);
}

void writeOverview(const Overview& overview, const fs::path& out) {
    writeFile(out / "results.json", overview.json());
    writeFile(out / "results.csv", overview.csv());
    writeFile(out / "index.html", overviewPage(overview, out));
}

}  // namespace grader
