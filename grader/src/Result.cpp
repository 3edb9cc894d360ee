#include "Result.h"

#include <algorithm>
#include <cmath>

#include "Fields.h"
#include "report/PlainText.h"

namespace grader {

namespace {

constexpr int kFormat = 1;

/// A frame without points is only shown. It decides nothing, unless the grader failed there.
bool decides(const CheckResult& check) {
    return check.kind != "frame" || check.maxPoints > 0 || check.status == Status::graderError ||
           check.status == Status::pending;
}

Status statusOfTask(const std::vector<CheckResult>& checks) {
    std::vector<const CheckResult*> deciding;
    for (const CheckResult& each : checks)
        if (decides(each))
            deciding.push_back(&each);
    const auto all = [&](Status status) {
        return std::all_of(deciding.begin(), deciding.end(),
                           [&](const CheckResult* each) { return each->status == status; });
    };
    for (const Status same : {Status::pass, Status::notImplemented, Status::pending})
        if (all(same))
            return same;
    if (std::any_of(deciding.begin(), deciding.end(),
                    [](const CheckResult* each) { return each->points > 0; }))
        return Status::partial;
    // Nothing earned: the first reason other than a missing implementation is the telling one.
    for (const CheckResult* each : deciding)
        if (each->status != Status::notImplemented)
            return each->status;
    return Status::fail;
}

Json jsonOf(const Diagnostic& each) {
    return {{"file", each.file},         {"line", each.line},       {"column", each.column},
            {"severity", each.severity}, {"message", each.message}, {"source", each.source}};
}

/// The unrounded share of a part of the points: what they are counted anew from when the points of
/// the assignment change.
void addShare(Json& json, double points, double maxPoints) {
    if (points > 0 && points < maxPoints)
        json["share"] = points / maxPoints;
}

Json jsonOf(const FeatureResult& feature) {
    Json json = {{"id", feature.id},
                 {"title", feature.title},
                 {"points", rounded(feature.points)},
                 {"max_points", rounded(feature.maxPoints)},
                 {"message", feature.message}};
    addShare(json, feature.points, feature.maxPoints);
    if (!feature.maskPath.empty())
        json["mask"] = feature.maskPath;
    return json;
}

Json jsonOf(const Comparison& comparison) {
    return {{"what", comparison.what},
            {"expected", comparison.expected},
            {"got", comparison.got},
            {"tolerance", comparison.tolerance}};
}

Json jsonOf(const CheckResult& check) {
    Json json = {{"id", check.id},
                 {"kind", check.kind},
                 {"title", check.title},
                 {"status", judge::toString(check.status)},
                 {"points", rounded(check.points)},
                 {"max_points", rounded(check.maxPoints)},
                 {"message", check.message},
                 {"hint", check.hint}};
    if (check.visibility != kVisible)
        json["visibility"] = check.visibility;
    if (check.comparison)
        json["comparison"] = jsonOf(*check.comparison);
    addShare(json, check.points, check.maxPoints);
    for (const FeatureResult& feature : check.features)
        json["features"].push_back(jsonOf(feature));
    if (check.pictures) {
        const FrameScore& score = check.pictures->score;
        json["frame"] = {
            {"outliers", score.outliers}, {"mean_error", score.meanError}, {"score", score.score}};
    }
    for (const char* name : {"submission", "reference", "difference"})
        if (const auto path = check.imagePaths.find(name); path != check.imagePaths.end())
            json["images"][name] = path->second;
    return json;
}

Json jsonOf(const TaskResult& task) {
    Json json = {{"id", task.id},
                 {"title", task.title},
                 {"points", rounded(task.points)},
                 {"max_points", rounded(task.maxPoints)},
                 {"status", judge::toString(task.status)},
                 {"checks", Json::array()}};
    for (const CheckResult& check : task.checks)
        json["checks"].push_back(jsonOf(check));
    if (task.recognised)
        json["recognised"] = {{"mistakes", task.recognised->mistakes},
                              {"says", task.recognised->says},
                              {"section", task.recognised->section}};
    return json;
}

Json jsonOf(const AssignmentResult& result) {
    Json diagnostics = Json::array(), tasks = Json::array();
    for (const Diagnostic& each : result.diagnostics)
        diagnostics.push_back(jsonOf(each));
    for (const TaskResult& task : result.tasks)
        tasks.push_back(jsonOf(task));
    const Environment& here = result.environment;
    return {{"format", kFormat},
            {"assignment", result.assignment},
            {"title", result.title},
            {"status", result.status},
            {"points", rounded(result.points())},
            {"max_points", rounded(result.maxPoints())},
            {"seed", result.seed},
            {"build", {{"ok", result.buildOk}, {"diagnostics", diagnostics}}},
            {"tasks", tasks},
            {"inherited", result.inherited},
            {"ignored_files", result.ignoredFiles},
            {"notices", result.notices},
            {"environment",
             {{"grader", here.grader},
              {"compiler", here.compiler},
              {"glm", here.glm},
              {"gl_renderer", here.glRenderer},
              {"gl_version", here.glVersion},
              {"cpu", here.cpu},
              {"sandbox", here.sandbox}}},
            {"timing", result.timing}};
}

/// Frames of a manual task are there to be looked at; its points wait in a check of their own.
void leaveToAPerson(const Task& task, std::vector<CheckResult>& checks) {
    for (CheckResult& check : checks) {
        check.status = Status::pending;
        check.message = check.hint = "";
    }
    CheckResult check;
    check.id = task.id;
    check.kind = "manual";
    check.task = task.id;
    check.title = task.title;
    check.status = Status::pending;
    check.maxPoints = task.points;
    check.message = "a person looks at this and gives the points";
    checks.push_back(std::move(check));
}

/// Text of a student's making may hold anything: each text, wherever it stands, made safe to show.
void makeHarmless(Json& json) {
    if (json.is_string())
        json = harmless(json.get<std::string>(), true);
    else if (json.is_structured())
        for (Json& each : json)
            makeHarmless(each);
}

std::string dumped(Json json) {
    makeHarmless(json);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

double rounded(double points) {
    return std::round(points * 1e6) / 1e6;
}

double AssignmentResult::points() const {
    double sum = 0;
    for (const TaskResult& task : tasks)
        sum += task.points;
    return sum;
}

double AssignmentResult::maxPoints() const {
    double sum = 0;
    for (const TaskResult& task : tasks)
        sum += task.maxPoints;
    return sum;
}

double AssignmentResult::automaticPoints() const {
    double sum = 0;
    for (const TaskResult& task : tasks)
        sum += task.status == Status::pending ? 0 : task.maxPoints;
    return sum;
}

bool AssignmentResult::full() const {
    return status == "graded" && std::all_of(tasks.begin(), tasks.end(), [](const auto& task) {
               return task.status == Status::pass || task.status == Status::pending;
           });
}

bool AssignmentResult::notStarted() const {
    return status == "graded" && std::all_of(tasks.begin(), tasks.end(), [](const auto& task) {
               return task.status == Status::notImplemented || task.status == Status::pending;
           });
}

bool AssignmentResult::graderFailed() const {
    for (const TaskResult& task : tasks)
        for (const CheckResult& check : task.checks)
            if (check.status == Status::graderError)
                return true;
    return status == "grader_error";
}

void countTest(CheckResult& check, const Manifest& manifest, std::ptrdiff_t tests) {
    const Task& task = *manifest.task(check.task);
    check.maxPoints = (task.points - manifest.framePoints(task.id)) / static_cast<double>(tests);
    check.points = check.full() ? check.maxPoints : 0;
}

std::vector<TaskResult> groupByTask(const Manifest& manifest, std::vector<CheckResult> checks) {
    std::vector<TaskResult> tasks;
    for (const Task& task : manifest.tasks) {
        TaskResult result{task.id, task.title, 0, task.points, Status::graderError, {}, {}};
        for (CheckResult& check : checks)
            if (check.task == task.id)
                result.checks.push_back(std::move(check));
        for (CheckResult& check : result.checks)
            check.visibility = manifest.visibilityOf(check.id);
        if (task.manual)
            leaveToAPerson(task, result.checks);
        for (const CheckResult& check : result.checks)
            result.points += check.points;
        result.status = statusOfTask(result.checks);
        tasks.push_back(std::move(result));
    }
    return tasks;
}

std::string toJson(const AssignmentResult& result) {
    return dumped(jsonOf(result));
}

std::string toJson(const std::vector<AssignmentResult>& results) {
    if (results.size() == 1)
        return toJson(results.front());
    Json array = Json::array();
    for (const AssignmentResult& each : results)
        array.push_back(jsonOf(each));
    return dumped(array);
}

}  // namespace grader
