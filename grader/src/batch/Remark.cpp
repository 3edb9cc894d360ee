#include "batch/Remark.h"

#include <algorithm>

#include "JudgeFrames.h"

namespace grader {

namespace {

double shareOf(double points, double maxPoints) {
    return maxPoints > 0 ? points / maxPoints : 0;
}

void countFrame(CheckResult& check, const CheckResult& now) {
    const double share = shareOf(check.points, check.maxPoints);
    check.title = now.title;
    check.maxPoints = now.maxPoints;
    check.points = share * now.maxPoints;
    if (check.features.empty())
        return;
    check.points = 0;
    for (std::size_t i = 0; i < check.features.size(); ++i) {
        FeatureResult& feature = check.features[i];
        feature.points = shareOf(feature.points, feature.maxPoints) * now.features.at(i).maxPoints;
        feature.maxPoints = now.features.at(i).maxPoints;
        check.points += feature.points;
    }
}

}  // namespace

void remark(AssignmentResult& result, const Manifest& manifest,
            const std::map<std::string, std::string>& hintsThen) {
    const auto frames = frameChecks(manifest);
    std::vector<CheckResult> checks;
    std::map<std::string, std::optional<Recognised>> recognised;
    for (TaskResult& task : result.tasks) {
        recognised[task.id] = std::move(task.recognised);
        const auto tests =
            std::count_if(task.checks.begin(), task.checks.end(),
                          [](const CheckResult& each) { return each.kind == "test"; });
        for (CheckResult& check : task.checks) {
            if (check.kind == "manual")
                continue;  // groupByTask() adds it
            if (check.kind == "test")
                countTest(check, manifest, tests);
            else
                countFrame(check, *std::find_if(frames.begin(), frames.end(),
                                                [&](const CheckResult& each) {
                                                    return each.id == check.id;
                                                }));
            if (!check.full() && check.status != Status::buildError &&
                check.hint == hintsThen.at(check.task))
                check.hint = manifest.task(check.task)->hint;
            checks.push_back(std::move(check));
        }
    }
    result.title = manifest.title;
    result.tasks = groupByTask(manifest, std::move(checks));
    for (TaskResult& task : result.tasks)
        task.recognised = std::move(recognised[task.id]);
}

std::map<std::string, std::string> hintsOf(const Manifest& manifest) {
    std::map<std::string, std::string> hints;
    for (const Task& task : manifest.tasks)
        hints[task.id] = task.hint;
    return hints;
}

}  // namespace grader
