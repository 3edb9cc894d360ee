#include <algorithm>
#include <iostream>

#include "Error.h"
#include "Grade.h"
#include "ImageModule.h"
#include "commands/CourseCommands.h"
#include "commands/GradeCommand.h"

namespace grader {

namespace {

constexpr std::uint64_t kPublishedSeed = 1;

/// Says "new", "changed" or nothing, and writes only what differs.
bool update(const fs::path& file, const Picture& picture) {
    const bool known = fs::exists(file);
    if (known) {
        const Picture old = readPicture(file);
        bool same = old.sameSizeAs(picture);
        for (std::size_t i = 0; same && i < old.rgba.size(); ++i)
            same = i % 4 == 3 || old.rgba[i] == picture.rgba[i];
        if (same)
            return false;
        const FrameScore score = scoreFrame(picture, old, {}, 0);
        std::cout << fmt::format("changed  {}  {:.3f} % of the pixels\n", file.string(),
                                 100 * score.outliers);
    } else {
        std::cout << "new      " << file.string() << "\n";
    }
    writePicture(file, picture);
    return true;
}

void updateAssignment(const Grader& grader, const std::string& id) {
    const fs::path& root = grader.tools().root;
    const Manifest manifest = loadAssignment(root, id);
    if (!fs::exists(root / "solutions" / id))
        throw Error("references are drawn by the solution, and there is no solutions/{}", id);
    const fs::path folder = root / "reference_images" / id;
    std::vector<fs::path> written;
    int changed = 0;
    for (const auto& [tree, suffix] :
         {std::pair{"solutions", ".png"}, std::pair{"assignments", ".starter.png"}})
        for (const auto& [frame, picture] :
             grader.draw(manifest, grader.stageOf(manifest, tree), kPublishedSeed)) {
            written.push_back(folder / (frame + suffix));
            changed += update(written.back(), picture);
        }
    if (fs::is_directory(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            if (std::find(written.begin(), written.end(), entry.path()) == written.end())
                std::cout << "orphan   " << entry.path().string()
                          << "  no frame has this name: delete it\n";
    std::cout << fmt::format("{}: {} references, {} written\n", id, written.size(), changed);
}

}  // namespace

void addUpdateReferencesCommand(CLI::App& app, int& exitCode) {
    static std::vector<std::string> assignments;
    CLI::App* command = app.add_subcommand("update-references",
                                           "draw reference_images/ from solutions and starters");
    command->add_option("assignments", assignments, "default all");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        const auto sandbox = chooseSandbox();
        const Grader grader(tools, *sandbox);
        for (const std::string& id :
             assignments.empty() ? knownAssignments(tools.root) : assignments)
            updateAssignment(grader, id);
        exitCode = kFullMarks;
    });
}

}  // namespace grader
