#include "course/MistakeTable.h"

#include <fmt/format.h>

#include <algorithm>

namespace grader {

void MistakeTable::add(const Mistake& mistake, const std::vector<CheckResult>& checks) {
    Row row{mistake.id, {}};
    for (const CheckResult& check : checks) {
        CheckResult kept;
        kept.id = check.id;
        kept.status = check.status;
        kept.points = check.points;
        kept.maxPoints = check.maxPoints;
        row.checks.push_back(std::move(kept));
    }
    rows_.push_back(std::move(row));
}

std::vector<std::string> MistakeTable::neverFailed() const {
    std::vector<std::string> ids;
    if (rows_.empty())
        return ids;
    for (std::size_t i = 0; i < rows_.front().checks.size(); ++i) {
        const CheckResult& check = rows_.front().checks[i];
        if (check.maxPoints > 0 && std::all_of(rows_.begin(), rows_.end(), [&](const Row& row) {
                return row.checks.at(i).full();
            }))
            ids.push_back(check.id);
    }
    return ids;
}

std::string MistakeTable::text() const {
    if (rows_.empty())
        return "";
    constexpr std::size_t kGroup = 5;  // columns between gaps
    std::string text;
    std::size_t widest = 0;
    for (const Row& row : rows_)
        widest = std::max(widest, row.mistake.size());
    const auto& checks = rows_.front().checks;
    for (std::size_t i = 0; i < checks.size(); ++i)
        text += fmt::format("  {:>3} {}\n", i + 1, checks[i].id);
    for (const Row& row : rows_) {
        text += fmt::format("  {:<{}}  ", row.mistake, widest);
        for (std::size_t i = 0; i < row.checks.size(); ++i) {
            const CheckResult& check = row.checks[i];
            text += i && i % kGroup == 0 ? " " : "";
            text += check.full() ? "·" : check.points > 0 ? "◐" : "●";
        }
        text += "\n";
    }
    return text;
}

}  // namespace grader
