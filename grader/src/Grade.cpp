#include "Grade.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <future>

#include "Error.h"
#include "ImageModule.h"
#include "Prerequisites.h"

namespace grader {

namespace {

constexpr std::uint64_t kPublishedSeed = 1;

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string cpuModel() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    return "unknown";
}

/// Wrong, and it came through an unfilled region of the check's own task or one that it needs: not
/// wrong, but not implemented. A region of another task is no excuse.
void markUnimplemented(const Manifest& manifest, CheckResult& check) {
    if (check.status != Status::fail)
        return;
    const Task& task = *manifest.task(check.task);
    for (const std::string& id : check.todos) {
        const bool needed = std::any_of(
            task.needs.begin(), task.needs.end(),
            [&](const std::string& need) { return need.substr(need.find('/') + 1) == id; });
        if (id != task.id && !needed)
            continue;
        check.status = Status::notImplemented;
        check.message = "`" + id + "` is not implemented yet";
        return;
    }
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
    check.maxPoints = (task->points - manifest.framePoints(task->id)) / double(siblings);
    check.status = test.verdict.status;
    check.points = check.full() ? check.maxPoints : 0;
    check.message = test.verdict.message;
    check.todos = test.todos;
    markUnimplemented(manifest, check);
    check.hint = check.full() ? "" : (test.hint.empty() ? task->hint : test.hint);
    return check;
}

CheckResult checkOf(const Manifest& manifest, const Frame& frame) {
    CheckResult check;
    check.id = frame.id;
    check.kind = "frame";
    check.task = frame.task;
    check.title = frame.title;
    check.maxPoints = frame.points;
    check.hint = manifest.task(frame.task)->hint;
    return check;
}

/// A frame without points is shown and never scored. It counts as failed only for
/// markUnimplemented(), which tells an unfilled region.
Status statusOf(const Frame& frame, const FrameScore& score, const CheckResult& check) {
    if (frame.points == 0)
        return check.todos.empty() ? Status::pass : Status::fail;
    return score.score >= 1 ? Status::pass : score.score > 0 ? Status::partial : Status::fail;
}

void judgeFrame(const Manifest& manifest, const Frame& frame, FrameOutcome& outcome,
                const Picture& reference, const Picture& starter, CheckResult& check) {
    check.status = outcome.verdict.status;
    check.message = outcome.verdict.message;
    check.todos = outcome.todos;
    if (check.status != Status::pass)
        return;
    FramePictures pictures;
    pictures.score = scoreFrame(outcome.picture, reference, starter, frame.tolerance);
    check.points = pictures.score.score * frame.points;
    check.status = statusOf(frame, pictures.score, check);
    if (!check.full())
        check.message = explainScore(pictures.score, outcome.picture, reference);
    markUnimplemented(manifest, check);
    if (frame.points == 0 && check.status == Status::fail)
        check.status = Status::pass;  // the unfilled region belongs to another task
    if (check.full()) {
        check.message.clear();
        check.hint.clear();
    }
    pictures.submission = std::move(outcome.picture);
    pictures.reference = reference;
    check.pictures = std::move(pictures);
}

}  // namespace

AssignmentResult Grader::grade(const Manifest& manifest, const Submission& submission,
                               std::uint64_t seed) const {
    const auto start = std::chrono::steady_clock::now();
    Collected collected = collect(tools_.root, manifest, submission);
    AssignmentResult result;
    result.assignment = manifest.id;
    result.title = manifest.title;
    result.ignoredFiles = collected.ignored;
    result.notices = collected.notices;
    StageResult graded;
    if (collected.unreadable.empty()) {
        graded = gradeStage(manifest, collected.stage, seed);
        mendPrerequisites(*this, manifest, collected.stage, seed, graded, result.notices);
    } else {
        graded.build.diagnostics = collected.unreadable;
        graded.checks = unjudged(manifest);
    }
    for (const StagedFile& file : collected.stage.files)
        if (file.role == Role::inherited)
            result.inherited[file.name] = file.origin;
    result.tasks = groupByTask(manifest, std::move(graded.checks));
    fillIn(result, graded, seed);
    result.timing["total_seconds"] = secondsSince(start);
    return result;
}

void Grader::fillIn(AssignmentResult& result, const StageResult& graded, std::uint64_t seed) const {
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
    using Clock = std::chrono::steady_clock;
    const WorkFolder work;
    StageResult result;
    const auto building = Clock::now();
    result.build = builder_.build(stage, manifest.limits, work.path());
    result.buildSeconds = secondsSince(building);
    if (!result.build.ok) {
        result.checks = unjudged(manifest);
        return result;
    }
    const auto observing = Clock::now();
    auto drawing = std::async(std::launch::async,
                              [&] { return observer_.drawFrames(manifest, result.build, seed); });
    const auto tests = observer_.runTests(manifest, result.build, seed, work.path());
    for (const TestOutcome& test : tests)
        result.checks.push_back(checkOf(manifest, test, tests));
    Frames frames = drawing.get();
    result.graphics = frames.graphics;
    judgeFrames(manifest, std::move(frames), seed, result.checks);
    result.observeSeconds = secondsSince(observing);
    return result;
}

void Grader::judgeFrames(const Manifest& manifest, Frames frames, std::uint64_t seed,
                         std::vector<CheckResult>& checks) const {
    const References& known = references(manifest, seed);
    for (const Frame& frame : manifest.frames) {
        CheckResult check = checkOf(manifest, frame);
        const Reference& reference = known.at(frame.id);
        judgeFrame(manifest, frame, frames.byId[frame.id], reference.picture, reference.starter,
                   check);
        checks.push_back(std::move(check));
    }
}

const Grader::References& Grader::references(const Manifest& manifest, std::uint64_t seed) const {
    const std::scoped_lock lock(referencesMutex_);
    auto known = references_.find({manifest.id, seed});
    if (known == references_.end())
        known = references_
                    .emplace(std::pair{manifest.id, seed}, seed == kPublishedSeed
                                                               ? loadReferences(manifest)
                                                               : drawReferences(manifest, seed))
                    .first;
    return known->second;
}

/// Nothing is stored for a seed that is not published: the solution draws the references now.
Grader::References Grader::drawReferences(const Manifest& manifest, std::uint64_t seed) const {
    if (!fs::exists(tools_.root / "solutions" / manifest.id))
        throw Error(
            "seed {} needs solutions/{}, which is not here: only seed {} has stored "
            "references",
            seed, manifest.id, kPublishedSeed);
    References all;
    auto pictures = draw(manifest, stageOf(manifest, "solutions"), seed);
    auto starters = draw(manifest, stageOf(manifest, "assignments"), seed);
    for (const Frame& frame : manifest.frames)
        all[frame.id] = {std::move(pictures[frame.id]), std::move(starters[frame.id])};
    return all;
}

Grader::References Grader::loadReferences(const Manifest& manifest) const {
    References all;
    const fs::path folder = tools_.root / "reference_images" / manifest.id;
    for (const Frame& frame : manifest.frames) {
        Reference& reference = all[frame.id];
        for (const auto& [suffix, picture] : {std::pair{".png", &reference.picture},
                                              std::pair{".starter.png", &reference.starter}}) {
            const fs::path file = folder / (frame.id + suffix);
            if (!fs::exists(file))
                throw Error("{} is missing: run ./grade update-references {}", file.string(),
                            manifest.id);
            *picture = readPictureCached(file, tools_.cache / "pictures");
            if (picture->width != frame.width || picture->height != frame.height)
                throw Error(
                    "{}: expected {} x {} pixels, found {} x {}: run ./grade "
                    "update-references {}",
                    file.string(), frame.width, frame.height, picture->width, picture->height,
                    manifest.id);
        }
    }
    return all;
}

std::vector<CheckResult> Grader::unjudged(const Manifest& manifest) const {
    std::vector<CheckResult> checks;
    const auto tests = observer_.listTests(manifest);
    for (const TestOutcome& test : tests)
        checks.push_back(checkOf(manifest, test, tests));
    for (const Frame& frame : manifest.frames)
        checks.push_back(checkOf(manifest, frame));
    for (CheckResult& check : checks) {
        check.status = Status::buildError;
        check.points = 0;
        check.message = "the submission does not compile";
        check.hint.clear();
    }
    return checks;
}

std::map<std::string, Picture> Grader::draw(const Manifest& manifest, const Stage& stage,
                                            std::uint64_t seed) const {
    const WorkFolder work;
    const BuildResult build = builder_.build(stage, manifest.limits, work.path());
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

Stage Grader::stageOf(const Manifest& manifest, const std::string& tree) const {
    return collect(tools_.root, manifest, {tools_.root / tree, true}).stage;
}

}  // namespace grader
