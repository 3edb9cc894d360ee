// The course check: one command that proves the course consistent. Every finding names the place
// and what mends it.

#include <iostream>

#include "Error.h"
#include "commands/CourseCommands.h"
#include "commands/GradeCommand.h"
#include "course/CheckReferences.h"
#include "course/CheckRuns.h"
#include "course/CheckTexts.h"

namespace grader {

namespace {

/// Number of findings in one assignment.
int checkAssignment(const Grader& grader, const std::string& id) {
    const Manifest manifest = loadAssignment(grader.tools().root, id);
    if (!fs::is_directory(grader.tools().root / "solutions" / id))
        throw Error("the course is checked against its solutions, and there is no solutions/{}",
                    id);
    Findings findings;
    checkTexts(grader.tools(), manifest, findings);
    checkReferences(grader, manifest, findings);
    checkPrograms(grader, manifest, findings);
    checkBlankRegions(grader, manifest, findings);
    Signatures signatures;
    const MistakeTable table = checkMistakes(grader, manifest, findings, signatures);
    checkSignatures(grader, manifest, signatures, findings);
    std::cout << table.text()
              << fmt::format("{}: {}\n", id,
                             findings.count() ? fmt::format("{} findings", findings.count())
                                              : "consistent");
    return findings.count();
}

}  // namespace

void addCheckCourseCommand(CLI::App& app, int& exitCode) {
    static std::vector<std::string> assignments;
    CLI::App* command = app.add_subcommand(
        "check-course", "prove manifests, starters, solutions, mistakes and references consistent");
    command->add_option("assignments", assignments, "default all");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        const auto sandbox = chooseSandbox(tools.confine());
        const Grader grader(tools, *sandbox);
        Findings ofTheCourse;
        checkIds(tools, ofTheCourse);
        int count = ofTheCourse.count();
        for (const std::string& id :
             assignments.empty() ? knownAssignments(tools.root) : assignments)
            count += checkAssignment(grader, id);
        exitCode = count ? kSomethingLost : kFullMarks;
    });
}

}  // namespace grader
