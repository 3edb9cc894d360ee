#pragma once

#include <map>

#include "Fields.h"
#include "Manifest.h"

namespace grader {

/// What a person decided about one task of one student.
struct Override {
    std::string student, task;
    double points = 0;
    std::string reason;  ///< one sentence, shown to the student
};

/// Decisions of people, from a table with the columns student, task, points, reason; and what the
/// automatic mark was when each was first applied, so that one that has changed since is noticed.
class Overrides {
public:
    Overrides() = default;
    /// `memory`: a file of ours, which need not exist. Throws Error that names the line for a task
    /// that is not there, points out of its range, a reason that is missing, or a line twice.
    Overrides(const fs::path& table, fs::path memory, const Manifest& manifest);

    /// The decision; null when there is none.
    const Override* find(const std::string& student, const std::string& task) const;

    /// The automatic points when this decision was first applied, which is now when it is new.
    double automaticWhenDecided(const Override& decision, double automaticNow);

    /// Decisions about students that are not in this list.
    std::vector<std::string> strangers(const std::vector<std::string>& students) const;

    void remember() const;

private:
    std::vector<Override> decisions_;
    fs::path memory_;
    std::map<std::string, double> before_, now_;  ///< by all that the decision says
};

}  // namespace grader
