// The course check: one command that proves the course consistent. Every finding names the place
// and what mends it.

#include <iostream>
#include <optional>

#include "Error.h"
#include "ExitCode.h"
#include "commands/CourseCommands.h"
#include "course/CheckReferences.h"
#include "course/CheckRuns.h"
#include "course/CheckTexts.h"
#include "course/NewAssignment.h"

namespace grader {

namespace {

struct Options {
    std::vector<std::string> assignments;
    bool drivers = false;
};

/// Number of findings in one assignment.
int checkAssignment(const Grader& grader, const Sandbox& sandbox, const std::string& id,
                    bool withDrivers) {
    const Manifest manifest = loadAssignment(grader.tools().root, id);
    if (!fs::is_directory(grader.tools().root / "solutions" / id))
        throw Error("the course is checked against its solutions, and there is no solutions/{}",
                    id);
    Findings findings;
    std::optional<DriverComparison> drivers;
    if (withDrivers)
        drivers.emplace(grader.tools(), sandbox, manifest, findings);
    DriverComparison* const compared = drivers ? &*drivers : nullptr;
    checkTexts(grader.tools(), manifest, findings);
    checkReferences(grader, manifest, findings);
    checkPrograms(grader, manifest, findings, compared);
    checkBlankRegions(grader, manifest, findings);
    Signatures signatures;
    const MistakeTable table = checkMistakes(grader, manifest, findings, signatures, compared);
    checkSignatures(grader, manifest, signatures, findings);
    std::cout << table.text() << (drivers ? drivers->table() : "")
              << fmt::format("{}: {}\n", id,
                             findings.count() ? fmt::format("{} findings", findings.count())
                                              : "consistent");
    return findings.count();
}

}  // namespace

void addCheckCourseCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command = app.add_subcommand(
        "check-course", "prove manifests, starters, solutions, mistakes and references consistent");
    command->add_option("assignments", options.assignments, "default all");
    command->add_flag("--drivers", options.drivers,
                      "draw every program with another driver, too: it must be worth the same");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        requireSolutions(tools.root);
        const auto sandbox = chooseSandbox(tools.confine());
        const Grader grader(tools, *sandbox);
        Findings ofTheCourse;
        checkIds(tools, ofTheCourse);
        int count = ofTheCourse.count();
        for (const std::string& id :
             options.assignments.empty() ? knownAssignments(tools.root) : options.assignments)
            count += checkAssignment(grader, *sandbox, id, options.drivers);
        exitCode = count ? kSomethingLost : kFullMarks;
    });
}

}  // namespace grader
