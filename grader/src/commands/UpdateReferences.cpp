#include <algorithm>
#include <iostream>

#include "Error.h"
#include "ExitCode.h"
#include "Grade.h"
#include "ImageModule.h"
#include "References.h"
#include "commands/CourseCommands.h"

namespace grader {

namespace {

/// Writes what belongs into reference_images/NN-name, says what changed, and names what is left.
class ReferenceWriter {
public:
    ReferenceWriter(const Grader& grader, const std::string& id)
        : grader_(grader),
          manifest_(loadAssignment(grader.tools().root, id)),
          folder_(referenceFolder(grader.tools(), id)) {
        if (!fs::exists(grader.tools().root / "solutions" / id))
            throw Error("references are drawn by the solution, and there is no solutions/{}", id);
    }

    void run() {
        for (const auto& [name, picture] : drawReferences(grader_, manifest_, kPublishedSeed))
            updatePicture(folder_ / name, picture);
        updateSignatures();
        nameOrphans();
        std::cout << fmt::format("{}: {} references, {} written\n", manifest_.id, expected_.size(),
                                 changed_);
    }

private:
    /// Writes only what differs.
    void updatePicture(const fs::path& file, const Picture& picture) {
        expected_.push_back(file);
        if (fs::exists(file)) {
            const Picture old = readPicture(file);
            bool same = old.sameSizeAs(picture);
            for (std::size_t i = 0; same && i < old.rgba.size(); ++i)
                same = i % 4 == 3 || old.rgba[i] == picture.rgba[i];
            if (same)
                return;
            std::cout << fmt::format("changed  {}  {:.3f} % of the pixels\n", file.string(),
                                     100 * outlierShare(picture, old));
        } else {
            std::cout << "new      " << file.string() << "\n";
        }
        writePicture(file, picture);
        ++changed_;
    }

    void updateSignatures() {
        const fs::path file = signaturesFile(grader_.tools(), manifest_.id);
        expected_.push_back(file);
        const Signatures fresh = makeSignatures(grader_, manifest_);
        if (fs::exists(file)) {
            const std::string changed = changedSince(file, fresh);
            if (changed.empty())
                return;
            std::cout << "changed  " << file.string() << "  " << changed << "\n";
        } else {
            std::cout << "new      " << file.string() << "\n";
        }
        fresh.save(file);
        ++changed_;
    }

    /// A file that cannot be read (another format, cut short) is one to be written anew.
    static std::string changedSince(const fs::path& file, const Signatures& fresh) {
        try {
            return fmt::format("{}", fmt::join(differing(Signatures::load(file), fresh), ", "));
        } catch (const Error& error) {
            return error.what();
        }
    }

    void nameOrphans() const {
        for (const auto& entry : fs::directory_iterator(folder_))
            if (std::find(expected_.begin(), expected_.end(), entry.path()) == expected_.end())
                std::cout << "orphan   " << entry.path().string()
                          << "  belongs to no frame: delete it\n";
    }

    const Grader& grader_;
    const Manifest manifest_;
    const fs::path folder_;
    std::vector<fs::path> expected_;
    int changed_ = 0;
};

}  // namespace

void addUpdateReferencesCommand(CLI::App& app, int& exitCode) {
    static std::vector<std::string> assignments;
    CLI::App* command = app.add_subcommand(
        "update-references", "draw reference_images/ from solutions, mistakes and starters");
    command->add_option("assignments", assignments, "default all");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        const auto sandbox = chooseSandbox(tools.confine());
        const Grader grader(tools, *sandbox);
        for (const std::string& id :
             assignments.empty() ? knownAssignments(tools.root) : assignments)
            ReferenceWriter(grader, id).run();
        exitCode = kFullMarks;
    });
}

}  // namespace grader
