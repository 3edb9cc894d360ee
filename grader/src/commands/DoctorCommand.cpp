#include "commands/DoctorCommand.h"

#include <iostream>

#include "ExitCode.h"
#include "doctor/Doctor.h"

namespace grader {

void addDoctorCommand(CLI::App& app, int& exitCode) {
    static bool json = false, noSandbox = false;
    CLI::App* command = app.add_subcommand(
        "doctor", "which defences are active here, and what else decides results");
    command->add_flag("--json", json, "as JSON");
    command->add_flag("--no-sandbox", noSandbox, "as with ./grade --no-sandbox");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        const auto sandbox = chooseSandbox(tools.confine(), {.none = noSandbox});
        const Diagnosis diagnosis = diagnose(tools, *sandbox);
        std::cout << (json ? diagnosis.json() : diagnosis.text());
        exitCode = diagnosis.allActive() ? kFullMarks : kSomethingLost;
    });
}

}  // namespace grader
