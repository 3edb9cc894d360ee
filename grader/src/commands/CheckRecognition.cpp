// Mistakes are recognised: measured on a second, independently written version of each.

#include <iostream>

#include "Error.h"
#include "Grade.h"
#include "Mistakes.h"
#include "Prerequisites.h"
#include "Regions.h"
#include "commands/CourseCommands.h"
#include "commands/GradeCommand.h"

namespace grader {

namespace {

constexpr std::uint64_t kOtherSeed = 2;

struct Options {
    std::vector<std::string> assignments;
    std::string only;
};

int checkAssignment(const Grader& grader, const std::string& id, const std::string& only) {
    const fs::path& root = grader.tools().root;
    const Manifest manifest = loadAssignment(root, id);
    int findings = 0;
    const auto finding = [&](const std::string& text) {
        ++findings;
        std::cout << "  ✗ " << text << "\n" << std::flush;
    };
    for (const Mistake& mistake : readMistakes(root / "solutions" / id)) {
        if (!only.empty() && mistake.id.find(only) == std::string::npos)
            continue;
        if (mistake.second.empty()) {
            finding("mistake " + mistake.id + " has no second version");
            continue;
        }
        Stage stage = grader.stageOf(manifest, "solutions");
        StagedFile& file = *stage.find(mistake.file);
        file.content = withRegion(file.content, mistake.region, mistake.second).value();
        Grader::StageResult graded = grader.gradeStage(manifest, stage, kOtherSeed);
        if (!graded.build.ok) {
            finding("second version of " + mistake.id +
                    " does not compile: " + graded.build.diagnostics.front().message);
            continue;
        }
        std::vector<std::string> notices;
        mendPrerequisites(grader, manifest, stage, kOtherSeed, graded, notices);
        for (const std::string& each : unexpectedLosses(mistake, graded.checks))
            finding("second version: " + each);
    }
    std::cout << id << ": " << findings << " findings\n";
    return findings;
}

}  // namespace

void addCheckRecognitionCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command = app.add_subcommand(
        "check-recognition", "prove that mistakes are recognised when others make them");
    command->add_option("assignments", options.assignments, "default all");
    command->add_option("--only", options.only, "only mistakes whose id holds this text");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        const auto sandbox = chooseSandbox();
        const Grader grader(tools, *sandbox);
        int findings = 0;
        for (const std::string& id :
             options.assignments.empty() ? knownAssignments(tools.root) : options.assignments)
            findings += checkAssignment(grader, id, options.only);
        exitCode = findings ? kSomethingLost : kFullMarks;
    });
}

}  // namespace grader
