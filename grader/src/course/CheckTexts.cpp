#include "course/CheckTexts.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "Mistakes.h"
#include "References.h"
#include "Regions.h"

namespace grader {

namespace {

class TextCheck {
public:
    TextCheck(const Toolchain& tools, const Manifest& manifest, Findings& findings)
        : tools_(tools),
          manifest_(manifest),
          solution_(tools.root / "solutions" / manifest.id),
          findings_(findings) {}

    void run() {
        checkOutsideRegions();
        checkHeadings();
        checkFeatures();
        checkAssignmentFiles();
        checkSolutionFiles();
        checkReferenceFiles();
    }

private:
    void checkOutsideRegions() {
        for (const std::string& name : manifest_.submit)
            if (outsideRegions(readFile(manifest_.folder / name)) !=
                outsideRegions(readFile(solution_ / name)))
                findings_.add(
                    fmt::format("{}: starter and solution differ outside the TODO regions",
                                (manifest_.folder / name).string()),
                    "./grade sync-starters " + manifest_.id);
    }

    void checkHeadings() {
        const std::string handout = readFile(manifest_.folder / "README.md");
        for (const Task& task : manifest_.tasks) {
            const std::string wanted = fmt::format("`{}` … ({:g} points)", task.id, task.points);
            const std::regex heading(
                fmt::format("\n##+ [^\n]*`{}`[^\n]*\\({:g} points\\)", task.id, task.points));
            const auto found =
                std::distance(std::sregex_iterator(handout.begin(), handout.end(), heading), {});
            if (found != 1)
                findings_.add(fmt::format("{}: expected one heading ## {}, found {}",
                                          (manifest_.folder / "README.md").string(), wanted, found),
                              "write that heading into the handout");
        }
    }

    /// A feature is lost by the mistake that it is without.
    void checkFeatures() {
        const auto mistakes = readMistakes(solution_);
        for (const Frame& frame : manifest_.frames)
            for (const Feature& feature : frame.features) {
                const auto known =
                    std::find_if(mistakes.begin(), mistakes.end(),
                                 [&](const Mistake& each) { return each.id == feature.without; });
                if (known == mistakes.end() || !known->loses.contains(frame.task))
                    findings_.add(
                        fmt::format("frame {}: feature {} belongs to {}, and is without {}, which "
                                    "is no mistake that loses there",
                                    frame.id, feature.id, frame.task, feature.without),
                        "name a mistake of solutions/" + manifest_.id + "/mistakes.json");
            }
    }

    void checkAssignmentFiles() {
        static const std::set<std::string> kinds = {".cpp",  ".h",  ".inl",  ".vert",
                                                    ".frag", ".md", ".json", ".png"};
        for (const auto& entry : fs::recursive_directory_iterator(manifest_.folder))
            if (entry.is_regular_file() && !kinds.contains(entry.path().extension().string()))
                unexpected(entry.path());
    }

    void checkSolutionFiles() {
        std::set<fs::path> expected = {solution_ / "mistakes.json"};
        for (const std::string& name : manifest_.submit)
            expected.insert(solution_ / name);
        for (const Mistake& mistake : readMistakes(solution_))
            for (const char* folder : {"mistakes", "mistakes/second"})
                expected.insert(solution_ / folder / mistake.fileName());
        for (const auto& entry : fs::recursive_directory_iterator(solution_)) {
            const fs::path name = entry.path().lexically_relative(solution_);
            const std::string top = name.begin()->string();
            const bool ours =
                top == "variants" || top == "hidden_tests" || name.filename() == ".clang-format";
            if (entry.is_regular_file() && !ours && !expected.contains(entry.path()))
                unexpected(entry.path());
        }
    }

    void checkReferenceFiles() {
        const fs::path folder = referenceFolder(tools_, manifest_.id);
        if (!fs::is_directory(folder))
            return;
        const auto names = referenceNames(manifest_);
        for (const auto& entry : fs::directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            if (std::find(names.begin(), names.end(), name) == names.end() &&
                entry.path() != signaturesFile(tools_, manifest_.id))
                findings_.add(entry.path().string() + " belongs to no frame",
                              "rm " + entry.path().string());
        }
    }

    void unexpected(const fs::path& file) {
        findings_.add(file.string() + " is a file that nothing here uses", "rm " + file.string());
    }

    const Toolchain& tools_;
    const Manifest& manifest_;
    const fs::path solution_;
    Findings& findings_;
};

}  // namespace

void checkTexts(const Toolchain& tools, const Manifest& manifest, Findings& findings) {
    TextCheck(tools, manifest, findings).run();
}

void checkIds(const Toolchain& tools, Findings& findings) {
    std::map<std::string, int> tasks;
    std::map<std::string, std::map<std::string, int>> regions;  // by tree
    for (const std::string& id : knownAssignments(tools.root)) {
        const Manifest manifest = loadAssignment(tools.root, id);
        for (const Task& task : manifest.tasks)
            ++tasks[task.id];
        for (const char* tree : {"assignments", "solutions"})
            for (const std::string& name : manifest.submit)
                for (const auto& [region, text] :
                     regionsOf(readFile(tools.root / tree / id / name)))
                    ++regions[tree][region];
    }
    for (const auto& [task, count] : tasks) {
        if (count > 1)
            findings.add(fmt::format("{} tasks have the id {}", count, task),
                         "rename all but one, in assignment.json, handout, regions and tests");
        for (const char* tree : {"assignments", "solutions"})
            if (regions[tree][task] != 1)
                findings.add(fmt::format("{}/ has {} regions TODO({}), expected 1", tree,
                                         regions[tree][task], task),
                             "fence what the task asks for, once, in a file that is submitted");
    }
    for (const auto& [tree, all] : regions)
        for (const auto& [region, count] : all)
            if (!tasks.contains(region))
                findings.add(fmt::format("{}/ has a region TODO({}) that is no task", tree, region),
                             "add the task to assignment.json, or take the fence away");
}

}  // namespace grader
