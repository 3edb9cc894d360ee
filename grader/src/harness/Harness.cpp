#include "harness/Harness.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include "Error.h"
#include "Grade.h"
#include "batch/Intake.h"
#include "formats/Formats.h"
#include "harness/SubmissionMetadata.h"
#include "report/HtmlReport.h"
#include "report/TerminalReport.h"
#include "report/Words.h"

namespace grader {

namespace {

/// What a platform gets: the result, and in `scored` its document and pictures.
struct Outcome {
    AssignmentResult result;
    Scored scored;
};

/// What differs between platforms.
class Harness {
public:
    virtual ~Harness() = default;
    /// The folder that the submission is in.
    virtual fs::path submission() const = 0;
    virtual void deliver(Outcome outcome) const = 0;
    virtual void deliverFault() const = 0;
};

/// Gradescope shows no sum before the due date while a check waits for it.
bool sumIsShown(const AssignmentResult& result) {
    for (const TaskResult& task : result.tasks)
        for (const CheckResult& check : task.checks)
            if (check.visibility == kAfterDueDate)
                return false;
    return true;
}

/// Standard output is the instructor's; the file is shown to both.
class Gradescope : public Harness {
public:
    explicit Gradescope(const fs::path& root) : home_((root.empty() ? "/" : root) / "autograder") {}
    fs::path submission() const override { return home_ / "submission"; }

    void deliver(Outcome outcome) const override {
        std::cout << terminalReport(outcome.result, {})
                  << "Sandbox: " << outcome.result.environment.sandbox << "\n";
        const fs::path metadata = home_ / "submission_metadata.json";
        if (fs::is_regular_file(metadata))
            for (std::string& each :
                 remarksFrom(readFile(metadata), outcome.scored.points, sumIsShown(outcome.result)))
                outcome.scored.remarks.push_back(std::move(each));
        writeFile(results_, gradescopeResult(outcome.scored));
    }
    void deliverFault() const override { writeFile(results_, gradescopeFault()); }

private:
    const fs::path home_, results_ = home_ / "results/results.json";
};

class PrairieLearn : public Harness {
public:
    explicit PrairieLearn(const fs::path& root) : home_((root.empty() ? "/" : root) / "grade") {}
    fs::path submission() const override { return home_ / "student"; }
    void deliver(Outcome outcome) const override {
        writeFile(results_, prairieLearnResult(outcome.scored));
    }
    void deliverFault() const override { writeFile(results_, prairieLearnFault()); }

private:
    const fs::path home_, results_ = home_ / "results/results.json";
};

/// Takes out what its student is not to see. Points of tasks stay.
void leaveShown(AssignmentResult& result) {
    for (TaskResult& task : result.tasks) {
        std::erase_if(task.checks,
                      [](const CheckResult& check) { return check.visibility != kVisible; });
        if (std::all_of(task.checks.begin(), task.checks.end(),
                        [](const CheckResult& check) { return check.full(); }))
            task.recognised.reset();
    }
}

/// Whatever stands on standard output is shown to the student; the last line is read.
class Autolab : public Harness {
public:
    explicit Autolab(const fs::path& root) : home_(root) {}
    fs::path submission() const override { return home_ / "handin"; }

    void deliver(Outcome outcome) const override {
        leaveShown(outcome.result);
        std::cout << terminalReport(outcome.result, {});
        for (const std::string& each : outcome.scored.remarks)
            std::cout << each << "\n";
        std::cout << "Sandbox: " << outcome.result.environment.sandbox << "\n"
                  << autolabLine(outcome.scored) << std::flush;
    }
    void deliverFault() const override { std::cout << autolabFault() << std::flush; }

private:
    const fs::path home_;
};

std::unique_ptr<Harness> makeHarness(const std::string& platform, const fs::path& root) {
    if (platform == "gradescope")
        return std::make_unique<Gradescope>(root);
    if (platform == "prairielearn")
        return std::make_unique<PrairieLearn>(root);
    if (platform == "autolab")
        return std::make_unique<Autolab>(root);
    throw Error("there is no platform \"{}\"; known are {}", platform,
                fmt::join(platformNames(), ", "));
}

/// A fault of the grader's is no mark, however many checks were made.
void refuseFaults(const AssignmentResult& result) {
    std::string faults;
    for (const TaskResult& task : result.tasks)
        for (const CheckResult& check : task.checks)
            if (check.status == Status::graderError)
                faults += fmt::format("\n  {}: {}", check.id, check.message);
    if (result.graderFailed())
        throw Error("the grader's own fault in {}:{}", result.assignment, faults);
}

AssignmentResult grade(const Grader& grader, const Sandbox& sandbox, const Manifest& manifest,
                       const fs::path& folder, std::uint64_t seed) {
    if (!fs::is_directory(folder))
        throw Error("{}: expected the folder with the submission, found none", folder.string());
    const Toolchain& tools = grader.tools();
    const auto known = knownAssignments(tools.root);
    const Job job;
    const Entrant entrant = entrantOf("submission", folder, manifest, known);
    const Unpacked unpacked = layOut(tools, sandbox, job, entrant, known);
    if (!unpacked.refusal.empty())
        return grader.refuse(
            manifest, seed,
            {{entrant.kind == EntrantKind::clone ? "repository" : entrant.path.filename().string(),
              0, 0, "error", "it is refused: " + unpacked.refusal, ""}});
    AssignmentResult result = grader.grade(manifest, submissionIn(unpacked.folder, known), seed);
    if (!unpacked.notice.empty())
        result.notices.push_back(unpacked.notice);
    return result;
}

/// Writes the pictures below `work` and returns the folder of those that the student may see.
fs::path writePictures(const Grader& grader, const Manifest& manifest, AssignmentResult& result,
                       const fs::path& work) {
    std::vector<AssignmentResult> one = {std::move(result)};
    writeReportPictures(one, work / "all");
    const bool published = one.front().seed == kPublishedSeed;
    if (!published)
        copyPictures(one, grader.publicFrames(manifest, one.front().seed), work / "all",
                     work / "shown");
    result = std::move(one.front());
    return work / (published ? "all" : "shown");
}

/// Points are those of the document, where sums of thirds have no noise.
Scored scoredOf(const AssignmentResult& result, const fs::path& report) {
    Scored scored;
    scored.report = report;
    scored.result = parseJson(toJson(result), "the result document");
    for (const Json& task : scored.result.at("tasks")) {
        const double most = task.at("max_points");
        if (task.at("status") == "pending") {
            scored.remarks.push_back(fmt::format("{}: a person looks at this and gives up to {}.",
                                                 task.at("title").get<std::string>(),
                                                 showPoints(most)));
            continue;
        }
        scored.tasks[task.at("id")] = task.at("points");
        scored.points += task.at("points").get<double>();
        scored.maxPoints += most;
    }
    return scored;
}

void gradeAndDeliver(const PlatformRun& run, const Harness& harness) {
    const Toolchain tools = Toolchain::load();
    const Manifest manifest = loadAssignment(tools.root, run.assignment);
    const auto sandbox = chooseSandbox(
        tools.confine(), {.none = run.noSandbox, .strangers = true, .secrets = {tools.root}});
    const Grader grader(tools, *sandbox, {.context = run.context});
    Outcome outcome;
    outcome.result = grade(grader, *sandbox, manifest, harness.submission(), run.seed);
    refuseFaults(outcome.result);
    const WorkFolder work;
    const fs::path pictures = writePictures(grader, manifest, outcome.result, work.path());
    outcome.scored = scoredOf(outcome.result, pictures);
    harness.deliver(std::move(outcome));
}

}  // namespace

const std::vector<std::string>& platformNames() {
    static const std::vector<std::string> names = {"gradescope", "prairielearn", "autolab"};
    return names;
}

bool gradeForPlatform(const PlatformRun& run, const fs::path& root) {
    const auto harness = makeHarness(run.platform, root);
    try {
        gradeAndDeliver(run, *harness);
        return true;
    } catch (const std::exception& error) {
        harness->deliverFault();
        std::cerr << "grade: there is no mark, because the grader failed: " << error.what() << "\n";
        return false;
    }
}

}  // namespace grader
