#include "commands/CarryCommand.h"

#include <iostream>

#include "Carry.h"
#include "Error.h"
#include "ExitCode.h"
#include "Toolchain.h"

namespace grader {

void addCarryCommand(CLI::App& app, int& exitCode) {
    static std::string from, to;
    static bool force = false;
    CLI::App* command =
        app.add_subcommand("carry", "bring your finished files to the next assignment");
    command->footer(
        "Without it TO finds what it inherits from FROM where it is. Carried files count from then "
        "on, and\nthose of FROM stay as they are. What TO inherits from others is still taken from "
        "there.");
    command->add_option("from", from, "the finished assignment, such as 07-camera")->required();
    command->add_option("to", to, "the one that uses its files, such as 08-perspective")
        ->required();
    command->add_flag("--force", force,
                      "replace files in TO that differ; what was there is kept as *.before-carry");
    command->callback([&exitCode] {
        if (from == to)
            throw Error(
                "carry {} {}: the two are the same; name the assignment before, then the "
                "one that uses its files",
                from, to);
        std::cout << carry(Toolchain::load().root, from, to, force);
        exitCode = kFullMarks;
    });
}

}  // namespace grader
