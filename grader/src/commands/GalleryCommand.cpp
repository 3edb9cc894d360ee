#include <fmt/format.h>

#include <iostream>

#include "ExitCode.h"
#include "Toolchain.h"
#include "batch/Gallery.h"
#include "commands/ClassCommands.h"

namespace grader {

void addGalleryCommand(CLI::App& app, int& exitCode) {
    static std::string results, out;
    CLI::App* command =
        app.add_subcommand("gallery", "the pictures of a class without names, for the lecture");
    command->add_option("results", results, "what ./grade batch wrote to its --out")->required();
    command->add_option("--out", out, "folder for the page and its pictures, new or empty")
        ->required();
    command->callback([&exitCode] {
        const GalleryCount count = writeGallery(Toolchain::load().root, results, out);
        std::cout << fmt::format("{} pictures that differ, of {} students\nGallery: {}\n",
                                 count.pictures, count.students,
                                 fs::absolute(fs::path(out) / "index.html").string());
        exitCode = kFullMarks;
    });
}

}  // namespace grader
