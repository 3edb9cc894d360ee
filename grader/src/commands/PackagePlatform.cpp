#include "commands/PackagePlatform.h"

#include <iostream>

#include "Error.h"
#include "ExitCode.h"
#include "Grade.h"
#include "package/PlatformPackage.h"

namespace grader {

namespace {

struct Options {
    std::string assignment, out;
    std::uint64_t seed = kPublishedSeed;
};

/// A platform's package, and what is said about it.
struct Kind {
    const char* platform;
    const char* help;
    const char* out;  ///< where it goes by itself
    CourseFiles (*make)(const PackageOrder&);
    void (*write)(const CourseFiles&, const fs::path&);
    const char* next;
};

constexpr const char* kUnused = "not-for-grading";  // the attribute in .gitattributes

constexpr Kind kKinds[] = {
    {"gradescope", "the autograder of an assignment for Gradescope, a zip file", "autograder.zip",
     gradescopePackage, writeArchive,
     "Upload it where Gradescope asks for the autograder (Ubuntu 22.04), and give it 2 GB of "
     "memory there."},
    {"prairielearn", "an assignment for PrairieLearn's external grader: image, tests, README.md",
     "prairielearn", prairieLearnPackage, writeTree, "Go on with the README.md in it."},
    {"autolab", "an assignment for Autolab: autograde-Makefile, autograde.tar, image, README.md",
     "autolab", autolabPackage, writeTree, "Go on with the README.md in it."}};

/// A misspelt id would show what is meant to be hidden.
void refuseUnknownChecks(const Toolchain& tools, const Manifest& manifest) {
    if (manifest.visibility.empty())
        return;
    const auto sandbox = chooseSandbox(tools.confine());
    const auto ids = Grader(tools, *sandbox).checkIds(manifest);
    for (const auto& [id, visibility] : manifest.visibility)
        if (!ids.contains(id))
            throw Error(
                "{}: field \"visibility\" names \"{}\", and there is no such check; the checks "
                "are {}",
                (manifest.folder / "assignment.json").string(), id, fmt::join(ids, ", "));
}

void package(const Kind& kind, const Options& options) {
    const Toolchain tools = Toolchain::load();
    if (!fs::exists(tools.root / "grader/platforms"))
        throw Error(
            "there is no {}, so this is a student's copy: packages are made where the solutions "
            "are",
            (tools.root / "grader/platforms").string());
    const Manifest manifest = loadAssignment(tools.root, options.assignment);
    if (options.seed != kPublishedSeed && !fs::exists(tools.root / "solutions" / manifest.id))
        throw Error(
            "--seed {} needs solutions/{}, which draws its references; without it the seed "
            "is {}",
            options.seed, manifest.id, kPublishedSeed);
    refuseUnknownChecks(tools, manifest);
    const CourseFiles course = committedFiles(tools.root, kUnused);
    if (!course.files.contains("assignments/" + manifest.id + "/assignment.json"))
        throw Error("assignments/{} is not committed, and a package is made of what is",
                    manifest.id);
    const CourseFiles made = kind.make({course, manifest, options.seed});
    const fs::path out = options.out.empty() ? kind.out : options.out;
    kind.write(made, out);
    std::cout << fmt::format(
        "{} of commit {}, {} files: {}\n{}\ndocs/platforms.md says what its "
        "students will see.\n",
        manifest.id, course.commit.substr(0, 12), made.files.size(), fs::absolute(out).string(),
        kind.next);
}

}  // namespace

void addPackagePlatformCommands(CLI::App& app, int& exitCode) {
    static Options options;
    for (const Kind& kind : kKinds) {
        CLI::App* command = app.add_subcommand(fmt::format("package-{}", kind.platform), kind.help);
        command->add_option("assignment", options.assignment, "such as 06-rotation")->required();
        command->add_option("out", options.out,
                            fmt::format("file or folder to write; default {}", kind.out));
        command
            ->add_option("--seed", options.seed,
                         "seed of the random inputs that it grades with; other than 1 needs "
                         "solutions/, and is a secret of the instructor's")
            ->capture_default_str();
        command->callback([&kind, &exitCode] {
            package(kind, options);
            exitCode = kFullMarks;
        });
    }
}

}  // namespace grader
