#include <fmt/format.h>

#include <iostream>

#include "ExitCode.h"
#include "Toolchain.h"
#include "commands/PackageCommand.h"
#include "package/StudentCopy.h"

namespace grader {

namespace {

struct Options {
    std::string out, from;
    StudentCopyWish wish;
};

int packageStudents(const Options& options) {
    const fs::path root = options.from.empty() ? Toolchain::load().root : fs::path(options.from);
    const CourseFiles copy = studentCopy(root, options.wish);
    const fs::path out = options.out;
    if (out.extension() == ".zip" || out.extension() == ".tar")
        writeArchive(copy, out);
    else
        writeTree(copy, out);
    const auto& solved = options.wish.withSolutions;
    std::cout << fmt::format("{}: {} files of commit {}, {}\n", options.out, copy.files.size(),
                             copy.commit.substr(0, 12),
                             solved.empty() ? "no solution among them"
                                            : fmt::format("with the solutions of {} in solutions/",
                                                          fmt::join(solved, ", ")));
    for (const std::string& each : namesOfWhatIsLeftOut(root, copy))
        std::cout << "Look at: " << each << "\n";
    return kFullMarks;
}

}  // namespace

void addPackageStudentsCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command = app.add_subcommand(
        "package-students",
        "write the course as students get it: no solutions, mistakes, hidden tests or pages for "
        "instructors, no history");
    command
        ->add_option("out", options.out,
                     "an empty or new folder, or a file that ends with .zip or .tar")
        ->required();
    command->add_option("--from", options.from,
                        "the course's repository; default the one that this grader was built in");
    command->add_option("--upto", options.wish.upto,
                        "the last assignment that students have by now; default all");
    command
        ->add_option("--with-solutions", options.wish.withSolutions,
                     "an assignment whose solved files students get, too; may be said several "
                     "times, and several may stand with commas between")
        ->allow_extra_args(false)  // OUT may come next
        ->delimiter(',');
    command->callback([&exitCode] { exitCode = packageStudents(options); });
}

}  // namespace grader
