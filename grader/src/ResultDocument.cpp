#include "ResultDocument.h"

#include <limits>

namespace grader {

namespace {

double numberFrom(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<std::vector<double>> rowsFrom(const Json& json) {
    std::vector<std::vector<double>> rows;
    for (const Json& row : json)
        rows.push_back(numbersFrom(row));
    return rows;
}

/// The points of which `json` says the share, not rounded; where they are none or all it does not.
double pointsFrom(const Json& json) {
    return json.contains("share")
               ? json.at("share").get<double>() * json.at("max_points").get<double>()
               : json.at("points").get<double>();
}

FeatureResult featureFrom(const Json& json) {
    FeatureResult feature;
    feature.id = json.at("id");
    feature.title = json.at("title");
    feature.points = pointsFrom(json);
    feature.maxPoints = json.at("max_points");
    feature.message = json.at("message");
    feature.maskPath = json.value("mask", "");
    return feature;
}

CheckResult checkFrom(const Json& json, const std::string& task) {
    CheckResult check;
    check.id = json.at("id");
    check.kind = json.at("kind");
    check.task = task;
    check.title = json.at("title");
    check.status = judge::statusFromString(json.at("status"));
    check.points = pointsFrom(json);
    check.maxPoints = json.at("max_points");
    check.message = json.at("message");
    check.hint = json.at("hint");
    if (json.contains("comparison"))
        check.comparison = comparisonFrom(json.at("comparison"));
    if (json.contains("features"))
        for (const Json& feature : json.at("features"))
            check.features.push_back(featureFrom(feature));
    if (json.contains("frame")) {
        FramePictures& pictures = check.pictures.emplace();
        pictures.score.outliers = json.at("frame").at("outliers");
        pictures.score.meanError = json.at("frame").at("mean_error");
        pictures.score.score = json.at("frame").at("score");
    }
    if (json.contains("images"))
        check.imagePaths = json.at("images").get<std::map<std::string, std::string>>();
    return check;
}

TaskResult taskFrom(const Json& json) {
    TaskResult task;
    task.id = json.at("id");
    task.title = json.at("title");
    task.points = json.at("points");
    task.maxPoints = json.at("max_points");
    task.status = judge::statusFromString(json.at("status"));
    for (const Json& check : json.at("checks"))
        task.checks.push_back(checkFrom(check, task.id));
    if (json.contains("recognised")) {
        const Json& recognised = json.at("recognised");
        task.recognised = {recognised.at("mistakes").get<std::vector<std::string>>(),
                           recognised.at("says"), recognised.at("section")};
    }
    return task;
}

}  // namespace

Diagnostic diagnosticFrom(const Json& json) {
    return {json.at("file"),     json.at("line"),    json.at("column"),
            json.at("severity"), json.at("message"), json.at("source")};
}

std::vector<double> numbersFrom(const Json& json) {
    std::vector<double> numbers;
    for (const Json& each : json)
        numbers.push_back(numberFrom(each));
    return numbers;
}

Comparison comparisonFrom(const Json& json) {
    return {json.at("what"), rowsFrom(json.at("expected")), rowsFrom(json.at("got")),
            numberFrom(json.at("tolerance"))};
}

AssignmentResult resultFrom(const Json& document) {
    AssignmentResult result;
    result.assignment = document.at("assignment");
    result.title = document.at("title");
    result.status = document.at("status");
    result.seed = document.at("seed");
    result.buildOk = document.at("build").at("ok");
    for (const Json& each : document.at("build").at("diagnostics"))
        result.diagnostics.push_back(diagnosticFrom(each));
    for (const Json& each : document.at("tasks"))
        result.tasks.push_back(taskFrom(each));
    result.inherited = document.at("inherited").get<std::map<std::string, std::string>>();
    result.ignoredFiles = document.at("ignored_files").get<std::vector<std::string>>();
    result.notices = document.at("notices").get<std::vector<std::string>>();
    const Json& here = document.at("environment");
    result.environment = {here.at("grader"),      here.at("compiler"),   here.at("glm"),
                          here.at("gl_renderer"), here.at("gl_version"), here.at("cpu"),
                          here.at("sandbox")};
    result.timing = document.at("timing").get<std::map<std::string, double>>();
    return result;
}

}  // namespace grader
