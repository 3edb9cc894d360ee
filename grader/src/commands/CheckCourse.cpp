// The course check: one command that proves the course consistent. Every finding names the place
// and what to do about it.

#include <algorithm>
#include <iostream>
#include <regex>
#include <set>

#include "Error.h"
#include "Fields.h"
#include "Grade.h"
#include "Mistakes.h"
#include "Prerequisites.h"
#include "Regions.h"
#include "commands/CourseCommands.h"
#include "commands/GradeCommand.h"

namespace grader {

namespace {

constexpr std::uint64_t kPublishedSeed = 1;

class CourseCheck {
public:
    explicit CourseCheck(const Grader& grader) : grader_(grader), root_(grader.tools().root) {}

    /// Number of findings in one assignment.
    int check(const std::string& id) {
        findings_ = 0;
        const Manifest manifest = loadAssignment(root_, id);
        checkTexts(manifest);
        checkStarter(manifest);
        checkSolution(manifest);
        checkVariants(manifest);
        checkMistakes(manifest);
        checkReferences(manifest);
        std::cout << fmt::format("{}: {}\n", id,
                                 findings_ ? fmt::format("{} findings", findings_) : "consistent");
        return findings_;
    }

private:
    template <class... A>
    void finding(fmt::format_string<A...> format, A&&... arguments) {
        ++findings_;
        std::cout << "  ✗ " << fmt::format(format, std::forward<A>(arguments)...) << "\n"
                  << std::flush;
    }

    fs::path starterFile(const Manifest& m, const std::string& name) const {
        return root_ / "assignments" / m.id / name;
    }
    fs::path solutionFile(const Manifest& m, const std::string& name) const {
        return root_ / "solutions" / m.id / name;
    }

    /// One id everywhere: region in starter and solution, heading in the handout.
    void checkTexts(const Manifest& manifest) {
        const std::string handout = readFile(starterFile(manifest, "README.md"));
        for (const std::string& name : manifest.submit) {
            const std::string starter = readFile(starterFile(manifest, name));
            const std::string solution = readFile(solutionFile(manifest, name));
            if (outsideRegions(starter) != outsideRegions(solution))
                finding(
                    "{}: starter and solution differ outside the TODO regions: compare "
                    "assignments/{}/{} with solutions/{}/{}",
                    name, manifest.id, name, manifest.id, name);
        }
        for (const Task& task : manifest.tasks) {
            if (!hasRegion(manifest, task.id))
                finding("no submitted or inherited file has a region TODO({})", task.id);
            const std::regex heading(
                fmt::format("\n##+ [^\n]*`{}`[^\n]*\\({:g} points\\)", task.id, task.points));
            if (!std::regex_search(handout, heading))
                finding("README.md: expected a heading with `{}` and ({:g} points)", task.id,
                        task.points);
        }
    }
    bool hasRegion(const Manifest& manifest, const std::string& task) const {
        for (const StagedFile& file : grader_.stageOf(manifest, "assignments").files)
            if (file.role != Role::provided && regionsOf(file.content).contains(task))
                return true;
        return false;
    }

    void checkStarter(const Manifest& manifest) {
        const auto result =
            grader_.gradeStage(manifest, grader_.stageOf(manifest, "assignments"), kPublishedSeed);
        for (const Diagnostic& each : result.build.diagnostics)
            finding("starter: {}:{}: {}", each.file, each.line, each.message);
        for (const CheckResult& check : result.checks)
            if (check.status != Status::notImplemented && !allowedToPass(manifest, check.id))
                finding("starter: {} is {} with {:g} points, expected not_implemented: {}",
                        check.id, judge::toString(check.status), check.points, check.message);
    }
    static bool allowedToPass(const Manifest& manifest, const std::string& id) {
        const auto& passes = manifest.starterPasses;
        return std::find(passes.begin(), passes.end(), id) != passes.end();
    }

    void checkSolution(const Manifest& manifest) {
        const auto result =
            grader_.gradeStage(manifest, grader_.stageOf(manifest, "solutions"), kPublishedSeed);
        for (const Diagnostic& each : result.build.diagnostics)
            finding("solution: {}:{}: {}", each.file, each.line, each.message);
        for (const CheckResult& check : result.checks)
            if (!check.full())
                finding("solution: {} is {}: {}", check.id, judge::toString(check.status),
                        check.message);
    }

    /// Other right programs, in solutions/NN/variants/NAME/: laid over the solution, each earns
    /// everything.
    void checkVariants(const Manifest& manifest) {
        const fs::path folder = root_ / "solutions" / manifest.id / "variants";
        if (!fs::is_directory(folder))
            return;
        for (const auto& variant : fs::directory_iterator(folder)) {
            Stage stage = grader_.stageOf(manifest, "solutions");
            for (const auto& entry : fs::recursive_directory_iterator(variant)) {
                if (!entry.is_regular_file())
                    continue;
                const std::string name = entry.path().lexically_relative(variant).string();
                StagedFile* file = stage.find(name);
                if (!file || file->role == Role::provided)
                    finding("variant {}: {} is no submitted file", entry.path().string(), name);
                else
                    file->content = readFile(entry.path());
            }
            for (const CheckResult& check :
                 grader_.gradeStage(manifest, stage, kPublishedSeed).checks)
                if (!check.full())
                    finding("variant {}: {} is {}: {}", variant.path().filename().string(),
                            check.id, judge::toString(check.status), check.message);
        }
    }

    /// Each mistake loses points in exactly the tasks that its entry names, its own among them.
    void checkMistakes(const Manifest& manifest) {
        std::map<std::string, int> perTask;
        std::set<std::string> undetected;  // checks that no mistake fails
        bool first = true;
        for (const Mistake& mistake : readMistakes(root_ / "solutions" / manifest.id)) {
            Stage stage = grader_.stageOf(manifest, "solutions");
            StagedFile* file = stage.find(mistake.file);
            const auto text =
                file ? withRegion(file->content, mistake.region, mistake.body) : std::nullopt;
            if (!text) {
                finding("mistake {}: {} has no region {}", mistake.id, mistake.file,
                        mistake.region);
                continue;
            }
            file->content = *text;
            Grader::StageResult result = grader_.gradeStage(manifest, stage, kPublishedSeed);
            std::vector<std::string> notices;
            mendPrerequisites(grader_, manifest, stage, kPublishedSeed, result, notices);
            if (!result.build.ok) {
                finding("mistake {} does not compile: {}", mistake.id,
                        result.build.diagnostics.front().message);
                continue;
            }
            ++perTask[mistake.region];
            if (first)
                for (const CheckResult& check : result.checks)
                    if (check.maxPoints > 0)
                        undetected.insert(check.id);
            first = false;
            for (const CheckResult& check : result.checks)
                if (!check.full())
                    undetected.erase(check.id);
            for (const std::string& each : unexpectedLosses(mistake, result.checks))
                finding("{}", each);
        }
        for (const Task& task : manifest.tasks)
            if (perTask[task.id] < 4)
                finding("task {} has {} mistakes, expected at least 4", task.id, perTask[task.id]);
        for (const std::string& id : undetected)
            finding("no mistake fails {}: a check that nothing fails proves nothing", id);
    }

    /// References are what the solutions draw today.
    void checkReferences(const Manifest& manifest) {
        std::set<std::string> expected;
        for (const Frame& frame : manifest.frames) {
            expected.insert(frame.id + ".png");
            expected.insert(frame.id + ".starter.png");
        }
        const fs::path folder = root_ / "reference_images" / manifest.id;
        if (fs::is_directory(folder))
            for (const auto& entry : fs::directory_iterator(folder))
                if (!expected.contains(entry.path().filename().string()))
                    finding("{} belongs to no frame: delete it", entry.path().string());
    }

    const Grader& grader_;
    const fs::path root_;
    int findings_ = 0;
};

}  // namespace

void addCheckCourseCommand(CLI::App& app, int& exitCode) {
    static std::vector<std::string> assignments;
    CLI::App* command =
        app.add_subcommand("check-course", "prove starters, solutions and mistakes consistent");
    command->add_option("assignments", assignments, "default all");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        const auto sandbox = chooseSandbox();
        const Grader grader(tools, *sandbox);
        CourseCheck check(grader);
        int findings = 0;
        for (const std::string& id :
             assignments.empty() ? knownAssignments(tools.root) : assignments)
            findings += check.check(id);
        exitCode = findings ? kSomethingLost : kFullMarks;
    });
}

}  // namespace grader
