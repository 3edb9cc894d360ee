#include "batch/Overrides.h"

#include <algorithm>
#include <charconv>

#include "batch/Csv.h"
#include "batch/Written.h"

namespace grader {

namespace {

std::string keyOf(const Override& decision) {
    return fmt::format("{}\n{}\n{:g}\n{}", decision.student, decision.task, decision.points,
                       decision.reason);
}

double pointsIn(const std::string& text, const Task& task, const std::string& place) {
    double points = 0;
    const char* end = text.data() + text.size();
    const auto [stopped, failed] = std::from_chars(text.data(), end, points);
    if (failed != std::errc() || stopped != end || !(points >= 0 && points <= task.points))
        throw Error("{}: points: expected a number from 0 to {:g}, what {} is worth, found \"{}\"",
                    place, task.points, task.id, text);
    return points;
}

}  // namespace

Overrides::Overrides(const fs::path& file, fs::path memory, const Manifest& manifest)
    : memory_(std::move(memory)) {
    const CsvTable table = CsvTable::read(file);
    for (const char* each : {"student", "task", "points", "reason"})
        table.needColumn(each);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string place = table.place(row), id = table.cell(row, "task");
        const Task* task = manifest.task(id);
        if (!task) {
            std::vector<std::string> known;
            for (const Task& each : manifest.tasks)
                known.push_back(each.id);
            throw Error("{}: {} has no task \"{}\"; it has {}", place, manifest.id, id,
                        fmt::join(known, ", "));
        }
        Override decision{table.cell(row, "student"), id,
                          pointsIn(table.cell(row, "points"), *task, place),
                          table.cell(row, "reason")};
        if (decision.student.empty() || decision.reason.empty())
            throw Error("{}: a student and a reason are needed", place);
        if (find(decision.student, id))
            throw Error("{}: {} has a decision on {} already", place, decision.student, id);
        decisions_.push_back(std::move(decision));
    }
    if (fs::exists(memory_))
        before_ =
            fromWritten(memory_, "move it away, and every decision counts as one of today",
                        [](const Json& json) { return json.get<std::map<std::string, double>>(); });
}

const Override* Overrides::find(const std::string& student, const std::string& task) const {
    const auto found = std::find_if(
        decisions_.begin(), decisions_.end(),
        [&](const Override& each) { return each.student == student && each.task == task; });
    return found == decisions_.end() ? nullptr : &*found;
}

double Overrides::automaticWhenDecided(const Override& decision, double automaticNow) {
    const std::string key = keyOf(decision);
    const auto known = before_.find(key);
    return now_[key] = known == before_.end() ? automaticNow : known->second;
}

std::vector<std::string> Overrides::strangers(const std::vector<std::string>& students) const {
    std::vector<std::string> strangers;
    for (const Override& each : decisions_)
        if (std::find(students.begin(), students.end(), each.student) == students.end())
            strangers.push_back(each.student);
    return strangers;
}

void Overrides::remember() const {
    if (memory_.empty())
        return;
    auto all = now_;
    for (const Override& each : decisions_)  // those of students that were not graded this time
        if (const auto known = before_.find(keyOf(each)); known != before_.end())
            all.insert(*known);
    writeFile(memory_, Json(all).dump(2) + "\n");
}

}  // namespace grader
