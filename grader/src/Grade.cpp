#include "Grade.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <random>

#include "Error.h"
#include "JudgeFrames.h"
#include "Portability.h"
#include "Prerequisites.h"
#include "TimeBox.h"
#include "recognise/Recognise.h"

namespace grader {

namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The task that a test belongs to, its share of the points, and what became of it.
CheckResult checkOf(const Manifest& manifest, const TestOutcome& test,
                    const std::vector<TestOutcome>& all) {
    const auto task = std::find_if(manifest.tasks.begin(), manifest.tasks.end(),
                                   [&](const Task& each) { return each.suite() == test.suite; });
    const auto siblings = std::count_if(
        all.begin(), all.end(), [&](const TestOutcome& each) { return each.suite == test.suite; });
    CheckResult check;
    check.id = test.id();
    check.kind = "test";
    check.task = task->id;
    check.title = test.title;
    check.status = test.verdict.status;
    countTest(check, manifest, siblings);
    check.message = test.verdict.message;
    check.todos = test.todos;
    check.hidden = test.hidden;
    check.comparison = test.comparison;
    check.evidence = test.evidence;
    markUnimplemented(manifest, check);
    check.hint = check.full() ? "" : (test.hint.empty() ? task->hint : test.hint);
    return check;
}

using EvidenceById = std::map<std::string, std::vector<judge::Evidence>>;

EvidenceById evidenceIn(const std::vector<CheckResult>& checks) {
    EvidenceById evidence;
    for (const CheckResult& check : checks)
        evidence[check.id] = check.evidence;
    return evidence;
}

/// By what the task answers with the right version of all that it needs; failing that by what it
/// answers as it was handed in, for what is made in the region of a needed task: a guard inside the
/// traversal.
std::optional<Recognised> recogniseTask(const Signatures& known, const TaskResult& task,
                                        const EvidenceById& handedIn) {
    if (auto recognised = recognise(known, task.id, task.checks))
        return recognised;
    std::vector<CheckResult> checks = task.checks;
    for (CheckResult& check : checks)
        if (const auto own = handedIn.find(check.id); own != handedIn.end())
            check.evidence = own->second;
    // A usual slip would be one of what is needed as well.
    auto recognised = recognise(known, task.id, checks);
    return recognised && !recognised->mistakes.empty() ? recognised : std::nullopt;
}

bool isGradersFault(const CheckResult& check) {
    return check.status == Status::graderError;
}

/// Whether the machine may be to blame for what became of a check.
bool isDoubtful(const CheckResult& check) {
    return isGradersFault(check) || judge::wasKilledFromOutside({check.status, check.message});
}

bool isDoubtful(const Grader::StageResult& graded) {
    return graded.build.fromOutside ||
           std::any_of(graded.checks.begin(), graded.checks.end(),
                       [](const CheckResult& check) { return isDoubtful(check); });
}

void callTampered(CheckResult& check) {
    check.status = Status::tampered;
    check.message =
        "the submission's process gave an answer that only a fault of the grader would give, and "
        "there is none: " +
        check.message;
}

/// Makes a compiler run, which no cache can stand in for.
void makeNew(Stage& stage) {
    std::random_device random;
    for (StagedFile& file : stage.files)
        if (file.role == Role::own && (file.name.ends_with(".cpp") || file.name.ends_with(".h")))
            file.content += fmt::format("\nextern const int never_seen_{:08x};\n", random());
}

}  // namespace

AssignmentResult Grader::grade(const Manifest& manifest, const Submission& submission,
                               std::uint64_t seed) const {
    const auto start = std::chrono::steady_clock::now();
    Collected collected = collect(tools_.root, manifest, submission);
    AssignmentResult result = collected.unreadable.empty()
                                  ? gradeStaged(manifest, collected.stage, seed)
                                  : refuse(manifest, seed, collected.unreadable);
    result.ignoredFiles = collected.ignored;
    result.notices.insert(result.notices.begin(), collected.notices.begin(),
                          collected.notices.end());
    for (std::string& notice : portabilityNotices(collected.stage))
        result.notices.push_back(std::move(notice));
    for (const StagedFile& file : collected.stage.files)
        if (file.role == Role::inherited)
            result.inherited[file.name] = file.origin;
    result.timing["total_seconds"] = secondsSince(start);
    return result;
}

AssignmentResult Grader::refuse(const Manifest& manifest, std::uint64_t seed,
                                std::vector<Diagnostic> why) const {
    AssignmentResult result;
    StageResult graded;
    graded.build.diagnostics = std::move(why);
    result.tasks = groupByTask(manifest, unjudged(manifest));
    fillIn(result, manifest, graded, seed);
    return result;
}

AssignmentResult Grader::gradeStaged(const Manifest& manifest, Stage& stage,
                                     std::uint64_t seed) const {
    AssignmentResult result;
    StageResult graded = gradeStage(manifest, stage, seed);
    const EvidenceById handedIn = evidenceIn(graded.checks);
    mendPrerequisites(*this, manifest, stage, seed, graded, result.notices);
    result.tasks = groupByTask(manifest, std::move(graded.checks));
    for (TaskResult& task : result.tasks)
        if (task.status != Status::pass && graded.build.ok)
            task.recognised = recogniseTask(signatures(manifest), task, handedIn);
    fillIn(result, manifest, graded, seed);
    return result;
}

void Grader::fillIn(AssignmentResult& result, const Manifest& manifest, const StageResult& graded,
                    std::uint64_t seed) const {
    result.assignment = manifest.id;
    result.title = manifest.title;
    result.seed = seed;
    result.buildOk = graded.build.ok;
    result.diagnostics = graded.build.diagnostics;
    if (!result.buildOk)
        result.status = "build_error";
    else if (result.graderFailed())
        result.status = "grader_error";
    if (const std::string weakness = sandbox_.weakness(); !weakness.empty())
        result.notices.push_back(weakness);
    result.environment = {tools_.version,           tools_.compilerVersion,  tools_.glmVersion,
                          graded.graphics.renderer, graded.graphics.version, cpuModel(),
                          sandbox_.name()};
    result.timing["build_seconds"] = graded.buildSeconds;
    result.timing["observe_seconds"] = graded.observeSeconds;
}

Grader::StageResult Grader::gradeStage(const Manifest& manifest, const Stage& stage,
                                       std::uint64_t seed) const {
    StageResult first = gradeOnce(manifest, stage, seed);
    if (!isDoubtful(first))
        return first;
    // What looks like a fault of the grader or of the machine was said by a process that runs the
    // submission, and may be a lie. It is the submission's where it is said again and the starter,
    // which is ours, is graded in between without it. A machine that was short of something for a
    // while costs nobody points.
    Stage starter = stageOf(manifest, "assignments");
    if (first.build.fromOutside)
        makeNew(starter);
    const StageResult honest = gradeOnce(manifest, starter, seed);
    StageResult again = gradeOnce(manifest, stage, seed);
    if (again.build.fromOutside && honest.build.fromOutside)
        throw Error("nothing can be compiled on this machine: {}",
                    again.build.diagnostics.front().message);
    if (first.build.fromOutside || again.build.fromOutside)
        return again.build.fromOutside && first.build.ok ? first : again;
    for (std::size_t i = 0; i < again.checks.size(); ++i) {
        CheckResult& check = again.checks[i];
        const CheckResult& before = first.checks.at(i);
        const bool ofTheMachine = check.kind == "frame" && !again.couldDraw && !honest.couldDraw;
        if (isDoubtful(check) && !isDoubtful(before))
            check = before;
        else if (isGradersFault(check) && !ofTheMachine && honest.build.ok &&
                 !isGradersFault(honest.checks.at(i)))
            callTampered(check);
    }
    return again;
}

Grader::StageResult Grader::gradeOnce(const Manifest& manifest, const Stage& stage,
                                      std::uint64_t seed) const {
    using Clock = std::chrono::steady_clock;
    const Job job;
    StageResult result;
    const auto building = Clock::now();
    result.build = builder_.build(stage, manifest.limits, job);
    result.buildSeconds = secondsSince(building);
    if (!result.build.ok) {
        result.checks = unjudged(manifest);
        return result;
    }
    const auto observing = Clock::now();
    auto drawing = alongside([&] { return observer_.drawFrames(manifest, result.build, seed); });
    const auto tests = observer_.runTests(manifest, result.build, seed, job.work.path());
    for (const TestOutcome& test : tests)
        result.checks.push_back(checkOf(manifest, test, tests));
    Frames frames = drawing.get();
    result.graphics = frames.graphics;
    result.couldDraw = frames.possible;
    auto ofFrames = judgeFrames(manifest, std::move(frames), rules(manifest, seed));
    std::move(ofFrames.begin(), ofFrames.end(), std::back_inserter(result.checks));
    result.observeSeconds = secondsSince(observing);
    return result;
}

std::vector<CheckResult> Grader::gradeFrames(const Manifest& manifest, const Stage& stage,
                                             std::uint64_t seed) const {
    const Job job;
    const BuildResult build = builder_.build(stage, manifest.limits, job);
    if (!build.ok)
        return {};
    return judgeFrames(manifest, observer_.drawFrames(manifest, build, seed),
                       rules(manifest, seed));
}

const FrameRules& Grader::rules(const Manifest& manifest, std::uint64_t seed) const {
    const std::scoped_lock lock(truthMutex_);
    auto known = rules_.find({manifest.id, seed});
    if (known == rules_.end())
        known = rules_
                    .emplace(std::pair{manifest.id, seed},
                             rulesOf(manifest, seed == kPublishedSeed
                                                   ? loadReferences(tools_, manifest)
                                                   : drawReferences(*this, manifest, seed)))
                    .first;
    return known->second;
}

const std::set<std::string>& Grader::publicFrames(const Manifest& manifest,
                                                  std::uint64_t seed) const {
    const FrameRules& drawn = rules(manifest, seed);
    const std::scoped_lock lock(truthMutex_);
    auto known = publicFrames_.find({manifest.id, seed});
    if (known == publicFrames_.end()) {
        const Pictures published = loadReferences(tools_, manifest);
        std::set<std::string> same;
        for (const Frame& frame : manifest.frames)
            if (drawn.at(frame.id).truth().reference.rgba ==
                published.at(referenceName(frame)).rgba)
                same.insert(frame.id);
        known = publicFrames_.emplace(std::pair{manifest.id, seed}, std::move(same)).first;
    }
    return known->second;
}

const Signatures& Grader::signatures(const Manifest& manifest) const {
    const std::scoped_lock lock(truthMutex_);
    auto known = signatures_.find(manifest.id);
    if (known == signatures_.end()) {
        const fs::path file = signaturesFile(tools_, manifest.id);
        if (!fs::exists(file))
            throw Error("{} is missing: run ./grade update-references {}", file.string(),
                        manifest.id);
        known = signatures_.emplace(manifest.id, Signatures::load(file)).first;
    }
    return known->second;
}

std::vector<CheckResult> Grader::unjudged(const Manifest& manifest) const {
    std::vector<CheckResult> checks;
    const auto tests = observer_.listTests(manifest);
    for (const TestOutcome& test : tests)
        checks.push_back(checkOf(manifest, test, tests));
    auto ofFrames = frameChecks(manifest);
    std::move(ofFrames.begin(), ofFrames.end(), std::back_inserter(checks));
    for (CheckResult& check : checks) {
        check.status = Status::buildError;
        check.points = 0;
        check.message = "the submission does not compile";
        check.hint.clear();
    }
    return checks;
}

std::set<std::string> Grader::checkIds(const Manifest& manifest) const {
    std::set<std::string> ids;
    for (const CheckResult& each : unjudged(manifest))
        ids.insert(each.id);
    return ids;
}

std::map<std::string, Picture> Grader::draw(const Manifest& manifest, const Stage& stage,
                                            std::uint64_t seed) const {
    const Job job;
    const BuildResult build = builder_.build(stage, manifest.limits, job);
    if (!build.ok)
        throw Error("the frames of {} cannot be drawn: {}:{}: {}", manifest.id,
                    build.diagnostics.front().file, build.diagnostics.front().line,
                    build.diagnostics.front().message);
    Frames frames = observer_.drawFrames(manifest, build, seed);
    std::map<std::string, Picture> pictures;
    for (auto& [id, outcome] : frames.byId) {
        if (outcome.verdict.status != Status::pass)
            throw Error("frame {} of {} cannot be drawn: {}", id, manifest.id,
                        outcome.verdict.message);
        pictures[id] = std::move(outcome.picture);
    }
    return pictures;
}

double longestGrading(const Manifest& manifest) {
    const double once = longestBuild(manifest.limits) + longestObservation(manifest);
    // As it is, with files that do not compile replaced, and once for each task with what it needs
    // mended, which may mean that each of those is looked at and emptied; all of them twice more to
    // see whether a fault is the grader's.
    double times = 2;
    for (const Task& task : manifest.tasks)
        if (!task.needs.empty())
            times += 1 + 2 * static_cast<double>(task.needs.size());
    times *= 3;
    // References: from solution, starter, and what lacks a feature.
    times += 2;
    for (const Frame& frame : manifest.frames)
        times += static_cast<double>(frame.features.size());
    return times * once;
}

Stage Grader::stageOf(const Manifest& manifest, const std::string& tree) const {
    return collect(tools_.root, manifest, {tools_.root / tree, true}).stage;
}

}  // namespace grader
