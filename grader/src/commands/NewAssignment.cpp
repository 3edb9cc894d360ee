#include <fmt/format.h>

#include <iostream>

#include "ExitCode.h"
#include "Toolchain.h"
#include "commands/CourseCommands.h"
#include "course/NewAssignment.h"

namespace grader {

void addNewAssignmentCommand(CLI::App& app, int& exitCode) {
    static std::string id;
    CLI::App* command = app.add_subcommand(
        "new-assignment", "make a small assignment that is whole, to be replaced step by step");
    command
        ->add_option("id", id,
                     "two digits for the chapter, then a name: 12-texture-mapping. Needs "
                     "solutions/")
        ->required();
    command->callback([&exitCode] {
        makeAssignment(Toolchain::load().root, id);
        std::cout << fmt::format(
            "made     assignments/{0}/ and solutions/{0}/\n"
            "Next:\n"
            "  ./grade update-references {0}    # draws its pictures\n"
            "  ./grade check-course {0}         # proves it consistent\n"
            "  ./grade window {0}               # the starter\n"
            "  grep -rn AUTHOR: assignments/{0} solutions/{0}    # what to replace\n"
            "docs/new-assignment.md goes through it.\n",
            id);
        exitCode = kFullMarks;
    });
}

}  // namespace grader
