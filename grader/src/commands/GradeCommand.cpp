#include "commands/GradeCommand.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <set>

#include "Archive.h"
#include "Browser.h"
#include "Error.h"
#include "ExitCode.h"
#include "Grade.h"
#include "Process.h"
#include "harness/Harness.h"
#include "report/HtmlReport.h"
#include "report/TerminalPictures.h"
#include "report/TerminalReport.h"
#include "watch/Watch.h"

namespace grader {

namespace {

struct Options {
    std::vector<std::string> assignments;
    std::string submission, json, report, context = "auto", harness;
    std::uint64_t seed = 1;
    bool open = false, images = false, watch = false, noSandbox = false;

    /// Where the report goes if there is one.
    fs::path reportFolder(const Toolchain& tools) const {
        return report.empty() ? tools.root / "report" : fs::path(report);
    }
};

/// Which assignments of which folder are graded.
struct Selection {
    Submission submission;
    std::vector<std::string> assignments;
    std::unique_ptr<Job> unpacking;  ///< holds the files of an archive
    std::string notice;              ///< about the archive; may be empty
};

/// The folder that the option names, or what is in the archive that it names.
fs::path folderOf(const Toolchain& tools, const Sandbox& sandbox, const fs::path& named,
                  Selection& selection) {
    if (fs::is_directory(named))
        return named;
    if (!fs::is_regular_file(named))
        throw Error("--submission {}: there is no such folder or archive", named.string());
    static const std::set<std::string> sources = {".cpp", ".h", ".hpp", ".inl", ".vert", ".frag"};
    if (sources.contains(named.extension().string()))
        throw Error("--submission {}: expected a folder or an archive; put the file into a folder",
                    named.string());
    selection.unpacking = std::make_unique<Job>();
    const Unpacked unpacked =
        unpackArchive(tools, sandbox, *selection.unpacking, named, knownAssignments(tools.root));
    if (!unpacked.refusal.empty())
        throw Error("--submission {}: the archive is refused: {}", named.string(),
                    unpacked.refusal);
    selection.notice = unpacked.notice;
    return unpacked.folder;
}

Selection select(const Toolchain& tools, const Sandbox& sandbox, const Options& options) {
    const auto known = knownAssignments(tools.root);
    Selection selection;
    selection.assignments = options.assignments;
    for (const std::string& id : options.assignments)
        loadAssignment(tools.root, id);  // refuses unknown ones before anything is done
    if (options.submission.empty()) {
        selection.submission = {tools.root / "assignments", true};
        if (selection.assignments.empty())
            selection.assignments = known;
        return selection;
    }
    const fs::path folder = folderOf(tools, sandbox, options.submission, selection);
    selection.submission = submissionIn(folder, known);
    std::vector<std::string> present;
    for (const std::string& id : known)
        if (selection.submission.perAssignment &&
            fs::is_directory(fs::symlink_status(selection.submission.folder / id)))
            present.push_back(id);
    if (selection.assignments.empty())
        selection.assignments = present;
    if (present.empty() && options.assignments.size() != 1)
        throw Error(
            "--submission {}: no folder in it is named like an assignment, so it must hold "
            "the files of one: name that assignment, for instance ./grade {} --submission "
            "{}",
            options.submission, known.front(), options.submission);
    return selection;
}

bool worthPainting() {
    return isatty(STDOUT_FILENO) && !std::getenv("NO_COLOR");
}

/// Says why no pictures are shown where they were asked for.
TerminalStyle styleFor(const Options& options, bool quiet) {
    TerminalStyle style{worthPainting(), 80, false};
    if (!options.images || quiet)
        return style;
    const std::string why = whyNoPreviews(isatty(STDOUT_FILENO), std::getenv("COLORTERM"));
    if (!why.empty())
        std::cout << why << "\n";
    style.pictures = why.empty();
    return style;
}

void showInBrowser(const fs::path& page) {
    if (!openInBrowser(page))
        std::cerr << "No browser could be opened (xdg-open). Open this file yourself:\n  "
                  << page.string() << "\n";
}

/// A word as a shell takes it for this one.
std::string shellWord(const std::string& word) {
    const bool plain =
        !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char each) {
            return std::isalnum(each) || std::strchr("_-+=.,/:@%", each);
        });
    if (plain)
        return word;
    std::string quoted = "'";
    for (const char each : word)
        quoted += each == '\'' ? "'\\''" : std::string(1, each);
    return quoted + "'";
}

/// The command that shows in the browser what these options graded.
std::string commandWithPictures(const Options& options) {
    std::string command = "./grade --open";
    for (const std::string& each : options.assignments)
        command += " " + shellWord(each);
    if (!options.submission.empty())
        command += " --submission " + shellWord(options.submission);
    if (options.seed != Options().seed)
        command += fmt::format(" --seed {}", options.seed);
    if (options.context != Options().context)
        command += " --context " + options.context;
    return command;
}

int exitCodeOf(const std::vector<AssignmentResult>& results) {
    const auto any = [&](auto&& predicate) {
        return std::any_of(results.begin(), results.end(), predicate);
    };
    if (any([](const AssignmentResult& each) { return each.graderFailed(); }))
        return kGraderFailed;
    return any([](const AssignmentResult& each) { return !each.full(); }) ? kSomethingLost
                                                                          : kFullMarks;
}

/// One submission on a learning platform's machine.
int gradeThere(const Options& options) {
    if (options.assignments.size() != 1)
        throw Error("--harness {} grades one assignment: name it", options.harness);
    const bool marked = gradeForPlatform({.platform = options.harness,
                                          .assignment = options.assignments.front(),
                                          .seed = options.seed,
                                          .context = options.context,
                                          .noSandbox = options.noSandbox});
    removeAbandonedWork();
    return marked ? kFullMarks : kGraderFailed;
}

int watchAll(const Toolchain& tools, const Sandbox& sandbox, const Options& options,
             const Selection& selection) {
    if (selection.unpacking)
        throw Error(
            "--watch --submission {}: an archive does not change while you type: unpack it, and "
            "name the folder",
            options.submission);
    return watch(tools, sandbox,
                 {.assignments = selection.assignments,
                  .submission = selection.submission,
                  .renderer = {.context = options.context},
                  .style = {worthPainting(), 80, false},
                  .report = options.reportFolder(tools),
                  .writePage = !options.report.empty(),
                  .openPage = options.open});
}

int gradeAll(const Options& options) {
    const Toolchain tools = Toolchain::load();
    removeAbandonedWork();
    const auto sandbox = chooseSandbox(
        tools.confine(),
        {.none = options.noSandbox, .strangers = runsInCi(), .secrets = {tools.root}});
    const Selection selection = select(tools, *sandbox, options);
    if (options.watch)
        return watchAll(tools, *sandbox, options, selection);
    const Grader grader(tools, *sandbox, {.context = options.context});

    const bool quiet = options.json == "-";
    const TerminalStyle style = styleFor(options, quiet);
    std::vector<AssignmentResult> results;
    for (const std::string& id : selection.assignments) {
        const double cpu = cpuSeconds();
        results.push_back(
            grader.grade(loadAssignment(tools.root, id), selection.submission, options.seed));
        results.back().timing["cpu_seconds"] = cpuSeconds() - cpu;
        if (!selection.notice.empty())
            results.back().notices.push_back(selection.notice);
        if (!quiet)
            std::cout << terminalReport(results.back(), style) << "\n" << std::flush;
    }
    if (!quiet && results.size() > 1)
        std::cout << terminalSummary(results, style);

    // The verdict is on the screen; files and pictures follow.
    const int exitCode = exitCodeOf(results);
    const fs::path report = options.reportFolder(tools);
    if (options.open || !options.report.empty()) {
        writeReport(results, report);
        if (!quiet)
            std::cout << "Report: " << fs::absolute(report / "index.html").string() << "\n";
    } else if (!quiet && exitCode != kFullMarks) {
        std::cout << "Pictures: " << commandWithPictures(options) << "\n";
    }
    if (options.json == "-")
        std::cout << toJson(results);
    else if (!options.json.empty())
        writeFile(options.json, toJson(results));
    if (options.open)
        showInBrowser(fs::absolute(report / "index.html"));
    return exitCode;
}

}  // namespace

void addGradeCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command = app.add_subcommand("grade", "grade assignments (the default command)");
    command->add_option("assignments", options.assignments,
                        "assignments to grade; default all, or all that the submission has");
    command->add_option("--submission", options.submission,
                        "folder with one folder per assignment, or with the files of the one "
                        "assignment named; or an archive (zip, tar, tar.gz, tar.xz, tar.bz2) of "
                        "either; default assignments/");
    CLI::Option* json = command->add_option("--json", options.json,
                                            "write the result document to this file, - for "
                                            "standard output (then nothing else is printed)");
    command->add_option("--report", options.report, "write report and pictures to this folder");
    CLI::Option* seed = command
                            ->add_option("--seed", options.seed,
                                         "seed of random inputs; other than 1 needs "
                                         "solutions/")
                            ->envname("COURSE_SEED")
                            ->capture_default_str();
    command->add_flag("--open", options.open,
                      "write the report (default folder: report/) and open it in the browser");
    CLI::Option* images = command->add_flag(
        "--images", options.images,
        "show small pictures of lost frames, where the terminal has 24-bit colour");
    command
        ->add_option("--context", options.context,
                     "what draws the frames: auto takes osmesa, "
                     "or egl where there is no OSMesa")
        ->check(CLI::IsMember({"auto", "osmesa", "egl"}))
        ->capture_default_str();
    command
        ->add_flag("--watch", options.watch,
                   "grade again whenever a file is saved, and say what changed, until q or Ctrl-C; "
                   "with --open the page in the browser follows")
        ->excludes(json)
        ->excludes(seed)
        ->excludes(images);
    command->add_flag("--no-sandbox", options.noSandbox,
                      "run the code as a plain process with limits");
    command
        ->add_option("--harness", options.harness,
                     "grade on the machine of this learning platform: take the submission and "
                     "leave the result where it wants them; exit code 0 once there is a mark")
        ->check(CLI::IsMember(platformNames()))
        ->excludes("--submission", "--json", "--report", "--open", "--images", "--watch");
    command->callback([&exitCode] {
        exitCode = options.harness.empty() ? gradeAll(options) : gradeThere(options);
    });
}

}  // namespace grader
