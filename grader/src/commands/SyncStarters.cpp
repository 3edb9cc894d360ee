#include <fmt/format.h>

#include <iostream>

#include "ExitCode.h"
#include "Manifest.h"
#include "Toolchain.h"
#include "commands/CourseCommands.h"
#include "course/NewAssignment.h"
#include "course/SyncedStarter.h"

namespace grader {

namespace {

int syncAssignment(const Toolchain& tools, const std::string& id) {
    const Manifest manifest = loadAssignment(tools.root, id);
    int written = 0;
    for (const std::string& name : manifest.submit) {
        const fs::path file = manifest.folder / name;
        const std::string starter = readFile(file);
        const std::string text =
            syncedStarter(file.string(), starter, readFile(tools.root / "solutions" / id / name));
        if (text == starter)
            continue;
        writeFile(file, text);
        std::cout << "synced   " << file.string() << "\n";
        ++written;
    }
    return written;
}

}  // namespace

void addSyncStartersCommand(CLI::App& app, int& exitCode) {
    static std::vector<std::string> assignments;
    CLI::App* command = app.add_subcommand(
        "sync-starters", "carry text outside the TODO regions from solutions to starters");
    command->add_option("assignments", assignments, "default all");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        requireSolutions(tools.root);
        int written = 0;
        for (const std::string& id :
             assignments.empty() ? knownAssignments(tools.root) : assignments)
            written += syncAssignment(tools, id);
        std::cout << fmt::format("{} files written\n", written);
        exitCode = kFullMarks;
    });
}

}  // namespace grader
