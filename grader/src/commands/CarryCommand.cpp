#include "commands/CarryCommand.h"

#include <iostream>

#include "Carry.h"
#include "ExitCode.h"
#include "Toolchain.h"

namespace grader {

void addCarryCommand(CLI::App& app, int& exitCode) {
    static std::string from, to;
    static CarryWish wish;
    CLI::App* command =
        app.add_subcommand("carry", "bring your finished files to the next assignment");
    command->footer(
        "Files that both assignments hand in are copied. Those that TO inherits from FROM are "
        "found\n"
        "where they are, by grading and by the window, so they are copied with --copy only: then "
        "TO\n"
        "has its own, for instance to be handed in alone.");
    command->add_option("from", from, "the finished assignment, such as 07-camera")->required();
    command->add_option("to", to, "the one that uses its files, such as 08-perspective")
        ->required();
    command->add_flag("--copy", wish.copy,
                      "copy inherited files, too: then TO has its own, and is handed in with them");
    command->add_flag("--force", wish.force,
                      "replace files in TO that differ; what was there is kept as *.before-carry");
    command->callback([&exitCode] {
        std::cout << carry(Toolchain::load().root, from, to, wish);
        exitCode = kFullMarks;
    });
}

}  // namespace grader
