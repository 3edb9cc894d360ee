#pragma once

#include <string>
#include <vector>

#include "Mistakes.h"

namespace grader {

/// Mistakes × checks: what each mistake loses.
class MistakeTable {
public:
    void add(const Mistake& mistake, const std::vector<CheckResult>& checks);

    /// Checks worth points that no mistake has failed.
    std::vector<std::string> neverFailed() const;

    /// A row per mistake, a column per check: ● lost, ◐ in part, · kept. The columns are explained
    /// above the table.
    std::string text() const;

private:
    struct Row {
        std::string mistake;
        std::vector<CheckResult> checks;
    };
    std::vector<Row> rows_;
};

}  // namespace grader
