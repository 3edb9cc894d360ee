#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <vector>

#include "ExitCode.h"
#include "commands/BatchCommand.h"
#include "commands/CarryCommand.h"
#include "commands/ClassCommands.h"
#include "commands/CompareCommand.h"
#include "commands/CourseCommands.h"
#include "commands/DeveloperCommands.h"
#include "commands/DoctorCommand.h"
#include "commands/ExportCommand.h"
#include "commands/GradeCommand.h"
#include "commands/PackageCommand.h"
#include "commands/PackagePlatform.h"
#include "commands/PullRequestCommand.h"
#include "report/PlainText.h"

namespace {

bool isCommand(const CLI::App& app, const std::string& word) {
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    return std::any_of(commands.begin(), commands.end(),
                       [&](const CLI::App* each) { return each->get_name() == word; });
}

/// Without a command, the grader grades: `./grade 07-camera` is `./grade grade 07-camera`.
std::vector<std::string> withDefaultCommand(const CLI::App& app, int argc, char** argv) {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    const bool named = !arguments.empty() && (isCommand(app, arguments[0]) ||
                                              arguments[0] == "--help" || arguments[0] == "-h");
    if (!named)
        arguments.insert(arguments.begin(), "grade");
    std::reverse(arguments.begin(), arguments.end());  // the order that CLI11 wants
    return arguments;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app(
        "Grades the assignments of this course.\n"
        "Exit codes: 0 full marks, 1 something lost, 2 the grader or its use was wrong.");
    app.name("./grade");
    app.footer(
        "Without a command, ./grade grades:\n"
        "  ./grade                      every assignment\n"
        "  ./grade 06-rotation          one of them\n"
        "  ./grade 06-rotation --watch  again whenever a file is saved\n"
        "  ./grade 06-rotation --open   with a report of pictures, in the browser\n"
        "  ./grade --yes                without asking before packages are installed\n"
        "./grade grade --help has all options of grading.");
    app.require_subcommand(0, 1);
    int exitCode = grader::kGraderFailed;
    grader::addGradeCommand(app, exitCode);
    grader::addBatchCommand(app, exitCode);
    grader::addMergeCommand(app, exitCode);
    grader::addReplayCommand(app, exitCode);
    grader::addExportCommand(app, exitCode);
    grader::addGalleryCommand(app, exitCode);
    grader::addCompareCommand(app, exitCode);
    grader::addDoctorCommand(app, exitCode);
    grader::addPackagePlatformCommands(app, exitCode);
    grader::addWindowCommand(app);
    grader::addDebugCommand(app);
    grader::addCarryCommand(app, exitCode);
    grader::addUpdateReferencesCommand(app, exitCode);
    grader::addCheckCourseCommand(app, exitCode);
    grader::addPackageStudentsCommand(app, exitCode);
    grader::addPullRequestCommand(app, exitCode);
    grader::addSyncStartersCommand(app, exitCode);
    grader::addNewAssignmentCommand(app, exitCode);
    grader::addCheckRecognitionCommand(app, exitCode);
    try {
        app.parse(withDefaultCommand(app, argc, argv));
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : grader::kGraderFailed;
    } catch (const std::exception& error) {
        std::cerr << "grade: " << grader::harmless(error.what(), true) << "\n";
        return grader::kGraderFailed;
    }
    return exitCode;
}
