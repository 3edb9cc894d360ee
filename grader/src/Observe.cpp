#include "Observe.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "Error.h"
#include "Fields.h"
#include "Process.h"
#include "References.h"
#include "ResultDocument.h"
#include "TimeBox.h"
#include "subject/Subject.h"

namespace grader {

namespace {

using judge::Status;

/// CPU time of a runner, and the time that a test program may take, on a crowded machine.
constexpr int kRunnerSeconds = 60;
constexpr double kJudgeSeconds = kRunnerSeconds * double(protocol::kMostStretch);

/// After so many frames that ran out of time, others are tried only for the sake of a task that
/// none of those belongs to.
constexpr int kMostLateFrames = 3;

/// What a runner may use with all that it starts. It has a child for a call beside the one that
/// draws, each of which may have all that a submission may; files in memory; itself and bubblewrap.
/// So no memory runs out but for code that took more than its share. Of processes there are no more
/// than the sandbox's own limit allows, so that it is always this one that is noticed.
CgroupLimits limitsOf(const Manifest& manifest) {
    constexpr int kChildren = 2, kFilesInMemoryMib = 128, kOwnMib = 64;
    const int memory = memoryForOwn(manifest.limits.memoryMib);
    return {memory > 0 ? kChildren * memory + kFilesInMemoryMib + kOwnMib : 0, Limits{}.processes};
}

/// What a submission is told when the kernel steps in.
judge::KernelLimits toldOf(const Manifest& manifest, const Cgroup& cgroup) {
    return {cgroup.folder().string(), manifest.limits.memoryMib, Limits{}.processes};
}

/// Only a renderer on the CPU gives the same picture everywhere.
bool drawsOnTheCpu(const std::string& renderer) {
    return renderer.find("llvmpipe") != std::string::npos ||
           renderer.find("softpipe") != std::string::npos;
}

/// What a frame is drawn from where it has random parts. The submission's process gets to know it:
/// a secret seed, from which the tests' inputs follow, must not be told by it.
std::uint64_t frameSeed(const std::string& assignment, const std::string& frame,
                        std::uint64_t seed) {
    if (seed == kPublishedSeed)
        return seed;
    constexpr std::size_t kDigits = 15;
    const std::string hash = sha256(fmt::format("{} {} {}", seed, assignment, frame));
    return std::stoull(hash.substr(0, kDigits), nullptr, 16);
}

/// What draws; or why it cannot draw frames for grading.
std::string askForGraphics(judge::Subject& subject, const protocol::Request& request,
                           protocol::GraphicsInfo& graphics) {
    const protocol::Answer answer = subject.ask(request);
    if (answer.outcome != protocol::Outcome::ok)
        return judge::explain("OpenGL", request, answer).message;
    try {
        graphics = protocol::decodeGraphics(answer.payload);
    } catch (const protocol::ProtocolError& error) {
        return fmt::format("OpenGL: {}", error.what());
    }
    if (!drawsOnTheCpu(graphics.renderer))
        return fmt::format(
            "frames for grading must be drawn by llvmpipe or softpipe, because other "
            "renderers give other pixels; found \"{}\"",
            graphics.renderer);
    return "";
}

void requireSuites(const Manifest& manifest, const std::vector<TestOutcome>& tests) {
    for (const TestOutcome& test : tests)
        if (std::none_of(manifest.tasks.begin(), manifest.tasks.end(),
                         [&](const Task& task) { return task.suite() == test.suite; }))
            throw Error(
                "test {} belongs to no task of {}: name its suite after one of them, such "
                "as {}",
                test.id(), manifest.id, manifest.tasks.front().suite());
    for (const Task& task : manifest.automaticTasks())
        if (task.points > manifest.framePoints(task.id) &&
            std::none_of(tests.begin(), tests.end(),
                         [&](const TestOutcome& test) { return test.suite == task.suite(); }))
            throw Error(
                "task \"{}\" of {} has no test: expected TEST({}, …) in assignments/{}/tests",
                task.id, manifest.id, task.suite(), manifest.id);
}

std::string lastLine(const std::string& text) {
    const auto end = text.find_last_not_of('\n');
    if (end == std::string::npos)
        return "";
    const auto start = text.rfind('\n', end);
    return text.substr(start == std::string::npos ? 0 : start + 1,
                       end - (start == std::string::npos ? 0 : start + 1) + 1);
}

/// One element of what JudgeMain.cpp writes.
TestOutcome testOutcomeOf(const Json& json) {
    TestOutcome test;
    test.suite = json.at("suite");
    test.name = json.at("name");
    test.title = json.at("title");
    test.hint = json.at("hint");
    test.hidden = json.at("hidden");
    test.todos = json.at("todos");
    test.verdict = {judge::statusFromString(json.at("status")), json.at("message")};
    if (const Json& comparison = json.at("comparison"); !comparison.is_null())
        test.comparison = comparisonFrom(comparison);
    for (const Json& each : json.at("evidence"))
        test.evidence.push_back(
            {each.at("key"), each.at("outcome"), each.at("type"), numbersFrom(each.at("numbers"))});
    return test;
}

}  // namespace

std::vector<std::string> Observer::runnerCommand(const Manifest& manifest, const BuildResult& build,
                                                 const Cgroup& cgroup) const {
    Confinement confinement;
    confinement.readable = {tools_.kit, build.stage, build.object.parent_path()};
    confinement.workingFolder = build.stage;
    confinement.programs = {"sh", "nm", "addr2line"};  // of CrashReport.h
    confinement.user = build.user;
    confinement.cgroup = cgroup.folder();
    // One thread, and no cache that another program could have filled.
    confinement.environment = {"GALLIUM_DRIVER=" + renderer_.driver, "LIBGL_ALWAYS_SOFTWARE=1",
                               "LP_NUM_THREADS=0", "MESA_SHADER_CACHE_DISABLE=true"};
    confinement.limits.memoryMib = memoryForOwn(manifest.limits.memoryMib);
    confinement.limits.cpuSeconds = kRunnerSeconds;
    return sandbox_.confine(confinement, {tools_.runner().string(), build.object.string(),
                                          tools_.kit.string(), renderer_.context});
}

std::vector<TestOutcome> Observer::runTests(const Manifest& manifest, const BuildResult& build,
                                            std::uint64_t seed, const fs::path& work) const {
    // Neither the seed nor the right answers may be read where a submission has no namespace of its
    // own: not on the command line, and in a folder that is closed.
    const fs::path closed = work / "judge";
    const fs::path resultFile = closed / "checks.json";
    makeClosedFolder(closed);
    writeFile(closed / "seed", std::to_string(seed));
    std::vector<std::string> command = {tools_.judge(manifest.id).string(),
                                        "--result",
                                        resultFile.string(),
                                        "--seed-file",
                                        (closed / "seed").string(),
                                        "--call-ms",
                                        fmt::format("{:.0f}", manifest.limits.callSeconds * 1000),
                                        "--output-kib",
                                        std::to_string(manifest.limits.outputKib),
                                        "--patience",
                                        fmt::format("{:.0f}", 0.8 * kJudgeSeconds)};
    const Cgroup cgroup(limitsOf(manifest));
    if (const auto told = toldOf(manifest, cgroup); !told.cgroup.empty())
        command.insert(command.end(),
                       {"--cgroup", told.cgroup, "--memory-mib", std::to_string(told.memoryMib),
                        "--processes", std::to_string(told.processes)});
    command.push_back("--");
    const auto runner = runnerCommand(manifest, build, cgroup);
    command.insert(command.end(), runner.begin(), runner.end());
    fs::remove(resultFile);
    const ProcessResult ran = run(command, kJudgeSeconds);
    try {
        if (!fs::exists(resultFile))
            throw Error("the test program {} wrote no result ({}): {}", command.front(),
                        ran.timedOut ? "it did not end"
                        : ran.signal ? fmt::format("signal {}", ran.signal)
                                     : fmt::format("exit {}", ran.exitCode),
                        lastLine(ran.output));
        const Json document = parseJsonFile(resultFile.string());
        std::vector<TestOutcome> outcomes;
        for (const Json& each : document.at("checks"))
            outcomes.push_back(testOutcomeOf(each));
        requireSuites(manifest, outcomes);
        return outcomes;
    } catch (const std::exception& fault) {
        // It had read a submission's answers: whose fault it is shows who else meets it.
        auto outcomes = listTests(manifest);
        for (TestOutcome& each : outcomes)
            each.verdict = {Status::graderError, fault.what()};
        return outcomes;
    }
}

std::vector<TestOutcome> Observer::listTests(const Manifest& manifest) const {
    const ProcessResult ran = run({tools_.judge(manifest.id).string(), "--gtest_list_tests"}, 10.0);
    if (!ran.succeeded())
        throw Error("the test program of {} cannot be run: {}", manifest.id, lastLine(ran.output));
    std::vector<TestOutcome> tests;
    std::istringstream lines(ran.output);
    std::string suite;
    for (std::string line; std::getline(lines, line);) {
        line = line.substr(0, line.find("  #"));
        if (line.starts_with("  "))
            tests.push_back({.suite = suite, .name = line.substr(2), .title = line.substr(2)});
        else if (line.ends_with("."))
            suite = line.substr(0, line.size() - 1);
    }
    requireSuites(manifest, tests);
    return tests;
}

protocol::GraphicsInfo Observer::describeGraphics(const Job& job) const {
    BuildResult nothing;
    nothing.stage = job.work.path() / "stage";
    nothing.object = nothing.stage / "none.so";
    nothing.user = job.user.id();
    makeClosedFolder(nothing.stage);
    shareWithSandbox(nothing.stage, nothing.user, false);
    const Cgroup cgroup(limitsOf({}));
    const auto subject = judge::startSubject(runnerCommand({}, nothing, cgroup));
    protocol::Request request;
    request.timeoutMs = 10000;
    request.kind = protocol::RequestKind::graphics;
    protocol::GraphicsInfo graphics;
    if (const std::string fault = askForGraphics(*subject, request, graphics); !fault.empty())
        throw Error("{}", fault);
    return graphics;
}

double longestObservation(const Manifest& manifest) {
    constexpr double kGraceSeconds = 5;
    // Each of them may have to start OpenGL anew.
    const double frame =
        (manifest.limits.frameSeconds + protocol::kStartMs / 1000.0) * protocol::kMostStretch +
        kGraceSeconds;
    return kJudgeSeconds + static_cast<double>(manifest.frames.size() + 1) * frame;
}

Frames Observer::drawFrames(const Manifest& manifest, const BuildResult& build,
                            std::uint64_t seed) const {
    Frames frames;
    if (manifest.frames.empty())
        return frames;
    const Cgroup cgroup(limitsOf(manifest));
    const auto subject =
        judge::startSubject(runnerCommand(manifest, build, cgroup), toldOf(manifest, cgroup));
    protocol::Request request;
    request.timeoutMs = static_cast<std::uint32_t>(manifest.limits.frameSeconds * 1000);
    request.outputBytes = static_cast<std::uint32_t>(manifest.limits.outputKib) * 1024;
    request.kind = protocol::RequestKind::graphics;
    if (const std::string fault = askForGraphics(*subject, request, frames.graphics);
        !fault.empty()) {
        frames.possible = false;
        for (const Frame& frame : manifest.frames)
            frames.byId[frame.id].verdict = {Status::graderError, fault};
        return frames;
    }
    request.kind = protocol::RequestKind::frame;
    int late = 0;
    std::set<std::string> lateTasks;
    for (const Frame& frame : manifest.frames) {
        TimeBox::check();
        if (late >= kMostLateFrames && lateTasks.contains(frame.task)) {
            frames.byId[frame.id].verdict = {
                Status::timeout, fmt::format("the frame was not drawn: {} before it ran out of "
                                             "time",
                                             late)};
            continue;
        }
        request.name = frame.id;
        request.seed = frameSeed(manifest.id, frame.id, seed);
        request.width = frame.width;
        request.height = frame.height;
        protocol::Answer answer = subject->ask(request);
        FrameOutcome& outcome = frames.byId[frame.id];
        outcome.todos = answer.todos;
        if (answer.outcome == protocol::Outcome::timeout) {
            ++late;
            lateTasks.insert(frame.task);
        }
        const auto bytes = std::size_t(4) * static_cast<std::size_t>(frame.width) *
                           static_cast<std::size_t>(frame.height);
        if (answer.outcome == protocol::Outcome::ok && answer.payload.size() != bytes)
            outcome.verdict = {Status::tampered, "the frame: an answer that is no picture"};
        else if (answer.outcome == protocol::Outcome::ok) {
            outcome.undrawn = std::clamp(answer.code, 0, frame.width * frame.height);
            outcome.picture = {frame.width, frame.height, std::move(answer.payload)};
        } else
            outcome.verdict = judge::explain("the frame", request, answer);
    }
    return frames;
}

}  // namespace grader
