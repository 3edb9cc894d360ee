#include <iostream>

#include "Error.h"
#include "Manifest.h"
#include "Regions.h"
#include "Toolchain.h"
#include "commands/CourseCommands.h"
#include "commands/GradeCommand.h"

namespace grader {

namespace {

/// The solution's text with the starter's blanks in its regions. Throws Error when the two do not
/// have the same regions: then nothing can be carried over without guessing.
std::string synced(const std::string& name, const std::string& starter,
                   const std::string& solution) {
    const auto blanks = regionsOf(starter), solved = regionsOf(solution);
    std::string text = solution;
    for (const auto& [id, body] : solved) {
        if (!blanks.contains(id))
            throw Error(
                "{}: the solution has a region TODO({}) and the starter has none: add it "
                "there, with its blank inside",
                name, id);
        text = withRegion(text, id, blanks.at(id)).value();
    }
    for (const auto& [id, body] : blanks)
        if (!solved.contains(id))
            throw Error(
                "{}: the starter has a region TODO({}) and the solution has none: nothing "
                "was written",
                name, id);
    return text;
}

int syncAssignment(const Toolchain& tools, const std::string& id) {
    const Manifest manifest = loadAssignment(tools.root, id);
    int written = 0;
    for (const std::string& name : manifest.submit) {
        const fs::path file = manifest.folder / name;
        const std::string starter = readFile(file);
        const std::string text =
            synced(file.string(), starter, readFile(tools.root / "solutions" / id / name));
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
        int written = 0;
        for (const std::string& id :
             assignments.empty() ? knownAssignments(tools.root) : assignments)
            written += syncAssignment(tools, id);
        std::cout << fmt::format("{} files written\n", written);
        exitCode = kFullMarks;
    });
}

}  // namespace grader
