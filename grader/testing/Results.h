#pragma once

#include <string>

#include "Result.h"

namespace testing_help {

inline grader::CheckResult check(const std::string& id, grader::Status status, double points,
                                 double most, const std::string& message = "",
                                 const std::string& hint = "") {
    grader::CheckResult result;
    result.id = id;
    result.kind = "test";
    result.title = "title of " + id;
    result.status = status;
    result.points = points;
    result.maxPoints = most;
    result.message = message;
    result.hint = hint;
    return result;
}

inline grader::TaskResult task(const std::string& id, grader::Status status,
                               std::vector<grader::CheckResult> checks) {
    grader::TaskResult result{id, "Task " + id, 0, 0, status, std::move(checks), {}};
    for (const auto& each : result.checks) {
        result.points += each.points;
        result.maxPoints += each.maxPoints;
    }
    return result;
}

/// One task full, one lost.
inline grader::AssignmentResult sampleResult() {
    using grader::Status;
    grader::AssignmentResult result;
    result.assignment = "07-camera";
    result.title = "Camera";
    result.buildOk = true;
    result.tasks = {task("look-at", Status::pass, {check("LookAt.A", Status::pass, 60, 60)}),
                    task("rotate-up", Status::partial,
                         {check("RotateUp.A", Status::pass, 15, 15),
                          check("RotateUp.B", Status::fail, 0, 25,
                                "expected (1, 2, 3), got (3, 2, 1)", "Turn up too.")})};
    result.environment = {"1.0", "g++ 12", "0.9.9.8", "llvmpipe", "3.3", "a CPU", "bubblewrap"};
    result.timing = {{"total_seconds", 1.5}};
    return result;
}

}  // namespace testing_help
