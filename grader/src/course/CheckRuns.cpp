#include "course/CheckRuns.h"

#include <fmt/format.h>

#include <algorithm>

#include "Fields.h"
#include "Mistakes.h"
#include "Prerequisites.h"
#include "Regions.h"

namespace grader {

namespace {

constexpr int kFewestMistakes = 4;  // of a task
constexpr int kFewestVariants = 5;  // of an assignment

std::string statusOf(const CheckResult& check) {
    return fmt::format("{} is {} with {:g} of {:g} points: {}", check.id,
                       judge::toString(check.status), check.points, check.maxPoints, check.message);
}

/// As a submission is graded: with what its tasks need mended.
Grader::StageResult gradeMended(const Grader& grader, const Manifest& manifest, Stage stage) {
    Grader::StageResult result = grader.gradeStage(manifest, stage, kPublishedSeed);
    std::vector<std::string> notices;
    mendPrerequisites(grader, manifest, stage, kPublishedSeed, result, notices);
    return result;
}

std::set<std::string> lostTasks(const std::vector<CheckResult>& checks) {
    std::set<std::string> lost;
    for (const CheckResult& check : checks)
        if (!check.full())
            lost.insert(check.task);
    return lost;
}

void checkStarter(const Grader& grader, const Manifest& manifest, Findings& findings) {
    const auto result =
        grader.gradeStage(manifest, grader.stageOf(manifest, "assignments"), kPublishedSeed);
    const std::string mend = "edit the starter in assignments/" + manifest.id;
    for (const Diagnostic& each : result.build.diagnostics)
        findings.add(fmt::format("starter: {}:{}: {}", each.file, each.line, each.message), mend);
    const auto& passes = manifest.starterPasses;
    for (const CheckResult& check : result.checks)
        if (check.status != Status::notImplemented &&
            std::find(passes.begin(), passes.end(), check.id) == passes.end())
            findings.add("starter, expected not_implemented: " + statusOf(check),
                         mend + ", or the check, or \"starter_passes\" in assignment.json");
}

/// A misspelt id would show what is meant to be hidden.
void checkVisibility(const Grader& grader, const Manifest& manifest, Findings& findings) {
    const auto ids = grader.checkIds(manifest);
    for (const auto& [id, visibility] : manifest.visibility)
        if (!ids.contains(id))
            findings.add(
                fmt::format("\"visibility\" names \"{}\", and there is no such check", id),
                "edit assignment.json; the checks are " + fmt::format("{}", fmt::join(ids, ", ")));
}

void checkSolution(const Grader& grader, const Manifest& manifest, Findings& findings,
                   DriverComparison* drivers) {
    const Stage stage = grader.stageOf(manifest, "solutions");
    const auto result = grader.gradeStage(manifest, stage, kPublishedSeed);
    if (drivers && result.build.ok)
        drivers->compare("solution", stage, result.checks, true);
    const std::string mend = "./grade " + manifest.id + " --submission solutions";
    for (const Diagnostic& each : result.build.diagnostics)
        findings.add(fmt::format("solution: {}:{}: {}", each.file, each.line, each.message), mend);
    for (const CheckResult& check : result.checks)
        if (!check.full())
            findings.add("solution: " + statusOf(check), mend);
}

/// The tasks that a variant is to lose in; none where it is right.
std::set<std::string> lossesOf(const fs::path& variant) {
    using Tasks = std::set<std::string>;
    const fs::path file = variant / "loses.json";
    if (!fs::exists(file))
        return {};
    const Json json = parseJsonFile(file.string());
    if (!FieldKind<Tasks>::holds(json))
        throw Error("{}: expected {}, found {}", file.string(), FieldKind<Tasks>::name(),
                    json.dump());
    return json.get<Tasks>();
}

void checkVariant(const Grader& grader, const Manifest& manifest, const fs::path& variant,
                  Findings& findings, DriverComparison* drivers) {
    const std::string mend = "look at " + variant.string() + ", then at the check";
    Stage stage = grader.stageOf(manifest, "solutions");
    layOver(stage, variant);
    const std::set<std::string> expected = lossesOf(variant);
    const Grader::StageResult result = gradeMended(grader, manifest, stage);
    const auto& checks = result.checks;
    if (drivers && result.build.ok)
        drivers->compare(variant.filename().string(), stage, checks, expected.empty());
    for (const CheckResult& check : checks)
        if (!check.full() && !expected.contains(check.task))
            findings.add("variant " + variant.filename().string() + ": " + statusOf(check), mend);
    for (const std::string& task : expected)
        if (!lostTasks(checks).contains(task))
            findings.add("variant " + variant.filename().string() + " loses nothing in " + task,
                         mend);
}

}  // namespace

void checkPrograms(const Grader& grader, const Manifest& manifest, Findings& findings,
                   DriverComparison* drivers) {
    checkVisibility(grader, manifest, findings);
    checkStarter(grader, manifest, findings);
    checkSolution(grader, manifest, findings, drivers);
    const fs::path folder = grader.tools().root / "solutions" / manifest.id;
    int right = 0;
    for (const fs::path& variant : variantsOf(folder)) {
        checkVariant(grader, manifest, variant, findings, drivers);
        right += fs::exists(variant / "loses.json") ? 0 : 1;
    }
    if (right < kFewestVariants)
        findings.add(fmt::format("{} has {} right programs that are written otherwise, expected at "
                                 "least {}",
                                 (folder / "variants").string(), right, kFewestVariants),
                     "write another");
}

void checkBlankRegions(const Grader& grader, const Manifest& manifest, Findings& findings) {
    const Stage starter = grader.stageOf(manifest, "assignments");
    for (const Task& task : manifest.automaticTasks()) {
        Stage stage = grader.stageOf(manifest, "solutions");
        for (StagedFile& file : stage.files) {
            const auto blank = regionsOf(starter.find(file.name)->content);
            if (blank.contains(task.id))
                file.content =
                    withRegion(file.content, task.id, blank.at(task.id)).value_or(file.content);
        }
        const auto checks = gradeMended(grader, manifest, stage).checks;
        const std::set<std::string> lost = lostTasks(checks), expected = {task.id};
        if (lost != expected)
            findings.add(
                fmt::format("the solution with a blank {} loses in {}, expected in {} only",
                            task.id, fmt::join(lost, ", "), task.id),
                "make the blank neutral, or name the dependency in \"needs\"");
    }
}

MistakeTable checkMistakes(const Grader& grader, const Manifest& manifest, Findings& findings,
                           Signatures& signatures, DriverComparison* drivers) {
    const Stage solution = grader.stageOf(manifest, "solutions");
    const std::string mend = "edit solutions/" + manifest.id + "/mistakes.json, or the check";
    signatures.right = answersOf(grader.gradeStage(manifest, solution, kPublishedSeed).checks);
    MistakeTable table;
    std::map<std::string, int> perTask;
    for (const Mistake& mistake : readMistakes(grader.tools().root / "solutions" / manifest.id)) {
        Stage stage = stageWith(solution, mistake, mistake.body);
        Grader::StageResult result = grader.gradeStage(manifest, stage, kPublishedSeed);
        if (!result.build.ok) {
            findings.add(fmt::format("mistake {} does not compile: {}", mistake.id,
                                     result.build.diagnostics.front().message),
                         mend);
            continue;
        }
        signatures.mistakes.push_back(signatureOf(mistake, signatures.right, result.checks));
        if (drivers)
            drivers->compare(mistake.id, stage, result.checks, false);
        std::vector<std::string> notices;
        mendPrerequisites(grader, manifest, stage, kPublishedSeed, result, notices);
        ++perTask[mistake.region];
        table.add(mistake, result.checks);
        for (const std::string& each : unexpectedLosses(mistake, result.checks))
            findings.add(each, mend);
        if (!mistake.earnsNothing)
            continue;
        for (const CheckResult& check : result.checks)
            if (check.task == mistake.region && check.points > 0)
                findings.add(
                    fmt::format("mistake {} earns something: {}", mistake.id, statusOf(check)),
                    "ask for the value in that check, too");
    }
    for (const Task& task : manifest.automaticTasks()) {
        if (perTask[task.id] < kFewestMistakes)
            findings.add(fmt::format("task {} has {} mistakes, expected at least {}", task.id,
                                     perTask[task.id], kFewestMistakes),
                         mend);
    }
    for (const std::string& id : table.neverFailed())
        findings.add("no mistake fails " + id + ": a check that nothing fails proves nothing",
                     "add a mistake that it is there for, or take it out");
    return table;
}

}  // namespace grader
