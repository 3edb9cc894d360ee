#include "commands/PullRequestCommand.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

#include "Error.h"
#include "ExitCode.h"
#include "Fields.h"
#include "Grade.h"
#include "pull_request/GitHub.h"
#include "pull_request/Markdown.h"
#include "report/HtmlReport.h"
#include "report/PlainText.h"
#include "report/TerminalReport.h"
#include "report/Words.h"

namespace grader {

namespace {

struct Options {
    std::string event, base, head, repository, report, summary, outputs, context = "auto";
    double passFrom = 60;
    bool noSandbox = false;
};

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// The commits that the options name, or those of the event that GitHub wrote down.
PullRequest requestOf(const Options& options, const fs::path& root) {
    PullRequest request{options.repository.empty() ? root : fs::path(options.repository),
                        options.base, options.head};
    if (!request.base.empty() && !request.head.empty())
        return request;
    if (options.event.empty())
        throw Error(
            "no pull request is named: give --base COMMIT and --head COMMIT, or --event FILE "
            "with what GitHub wrote to $GITHUB_EVENT_PATH");
    try {
        const Json pull = Json::parse(readFile(options.event)).at("pull_request");
        if (request.base.empty())
            request.base = pull.at("base").at("sha");
        if (request.head.empty())
            request.head = pull.at("head").at("sha");
    } catch (const Json::exception& error) {
        throw Error(
            "{}: expected the event of a pull request, with pull_request.base.sha and "
            "pull_request.head.sha: {}",
            options.event, error.what());
    }
    return request;
}

/// GitHub's files collect what all steps write.
void appendTo(const std::string& file, const std::string& text) {
    std::ofstream out(file, std::ios::app | std::ios::binary);
    out << text;
    out.flush();
    if (!out)
        throw Error("{} cannot be written", file);
}

std::string outputsOf(const PullRequestResult& graded) {
    double points = 0, most = 0;
    for (const AssignmentResult& each : graded.results) {
        points += each.points();
        most += each.automaticPoints();
    }
    return fmt::format("points={}\nmax-points={}\npassed={}\n", showPoints(points),
                       showPoints(most), graded.passed() && !graded.graderFailed());
}

void tell(const PullRequestResult& graded, const fs::path& files, const Options& options) {
    std::string text;
    for (const AssignmentResult& each : graded.results)
        text += terminalReport(each, {false, 80, false}) + "\n";
    if (graded.results.empty())
        text = "No file that students hand in was changed: nothing to grade.\n";
    for (const std::string& each : graded.changes.misplaced)
        text += harmless(each) + "\n";
    if (variable("GITHUB_ACTIONS") == "true")
        std::cout << withoutCommands(text) << annotationsOf(graded, files);
    else
        std::cout << text;
    if (!options.summary.empty())
        appendTo(options.summary, summaryOf(graded));
    if (!options.outputs.empty())
        appendTo(options.outputs, outputsOf(graded));
}

int gradeChanges(const Options& options) {
    const Toolchain tools = Toolchain::load();
    const PullRequest request = requestOf(options, tools.root);
    const auto sandbox = chooseSandbox(
        tools.confine(), {.none = options.noSandbox, .strangers = true, .secrets = {tools.root}});
    std::vector<Manifest> course;
    for (const std::string& id : knownAssignments(tools.root))
        course.push_back(loadAssignment(tools.root, id));

    PullRequestResult graded;
    graded.passFrom = options.passFrom;
    graded.changes = changesOf(request, course);
    const WorkFolder files;
    for (const std::string& notice : takeFiles(request, course, files.path()))
        graded.changes.notices.push_back(notice);
    const Grader grader(tools, *sandbox, {.context = options.context});
    for (const std::string& id : graded.changes.assignments)
        graded.results.push_back(grader.grade(loadAssignment(tools.root, id),
                                              Submission{files.path(), true}, kPublishedSeed));
    if (!options.report.empty() && !graded.results.empty()) {
        writeReport(graded.results, options.report);
        writeFile(fs::path(options.report) / "result.json", toJson(graded.results));
    }
    tell(graded, files.path(), options);
    if (graded.graderFailed())
        return kGraderFailed;
    return graded.passed() ? kFullMarks : kSomethingLost;
}

/// Whoever looks at the summary alone reads that there is no mark, too.
int gradePullRequest(const Options& options) {
    try {
        return gradeChanges(options);
    } catch (const std::exception&) {
        if (!options.summary.empty())
            std::ofstream(options.summary, std::ios::app) << summaryOfFault();
        throw;
    }
}

}  // namespace

void addPullRequestCommand(CLI::App& app, int& exitCode) {
    static Options options;
    options.event = variable("GITHUB_EVENT_PATH");
    options.summary = variable("GITHUB_STEP_SUMMARY");
    options.outputs = variable("GITHUB_OUTPUT");
    CLI::App* command = app.add_subcommand(
        "pull-request",
        "grade the assignments that a pull request changes: its files of students, by this grader");
    command->add_option("--event", options.event,
                        "what GitHub tells of the pull request, JSON; default $GITHUB_EVENT_PATH");
    command->add_option("--base", options.base, "commit of the base branch; default the event's");
    command->add_option("--head", options.head, "commit to be merged; default the event's");
    command->add_option("--repository", options.repository,
                        "the repository that has both commits; default this one. The head is never "
                        "checked out");
    command
        ->add_option("--pass-from", options.passFrom,
                     "percent of its points from which on an assignment passes")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    command->add_option("--report", options.report,
                        "write report, pictures and result.json to this folder");
    command->add_option("--summary", options.summary,
                        "append the summary, Markdown, to this file; default "
                        "$GITHUB_STEP_SUMMARY");
    command->add_option("--outputs", options.outputs,
                        "append points, max-points and passed to this file; default "
                        "$GITHUB_OUTPUT");
    command
        ->add_option("--context", options.context,
                     "what draws the frames: auto takes osmesa, or egl where there is no OSMesa")
        ->check(CLI::IsMember({"auto", "osmesa", "egl"}))
        ->capture_default_str();
    command->add_flag("--no-sandbox", options.noSandbox,
                      "run the code as a plain process with limits");
    command->footer(
        "Exit codes: 0 every changed assignment passed (or none was changed), 1 one did not, or a "
        "file is in the wrong place, 2 the grader or its use was wrong.");
    command->callback([&exitCode] { exitCode = gradePullRequest(options); });
}

}  // namespace grader
