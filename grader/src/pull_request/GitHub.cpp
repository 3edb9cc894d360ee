#include "pull_request/GitHub.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "Regions.h"
#include "pull_request/Markdown.h"
#include "report/Words.h"

namespace grader {

namespace {

constexpr std::size_t kMostUnusedShown = 20;
constexpr std::size_t kMostChecksShown = 3;  // of one task; the report has all
constexpr int kMostAnnotations = 10;         // of each kind
constexpr const char* kFault =
    "The grader itself failed; this is not your mistake, and no mark. Please tell your "
    "instructor.\n\n";

std::vector<Diagnostic> diagnosticsOf(const AssignmentResult& result, const std::string& severity) {
    std::vector<Diagnostic> all;
    std::copy_if(result.diagnostics.begin(), result.diagnostics.end(), std::back_inserter(all),
                 [&](const Diagnostic& each) { return each.severity == severity; });
    return all;
}

/// The first error of each shader in the message of a check that needs it (cg::GlslStage), and what
/// is said about it below the compiler's log. None in any other message.
std::vector<Diagnostic> shaderErrorsIn(const CheckResult& check) {
    std::vector<Diagnostic> errors;
    if (check.status != Status::buildError)
        return errors;
    std::istringstream lines(check.message);
    for (std::string line; std::getline(lines, line);) {
        const auto found = parseDiagnostics(line);
        if (line.starts_with("hint: ") && !errors.empty())
            errors.back().message += "\n" + line;
        else if (!found.empty() && found[0].severity == "error" &&
                 (errors.empty() || errors.back().file != found[0].file))
            errors.push_back(found[0]);
    }
    return errors;
}

/// What no compiler accepts: of C++ every error, of each shader the first.
std::vector<Diagnostic> errorsOf(const AssignmentResult& result) {
    std::vector<Diagnostic> errors = diagnosticsOf(result, "error");
    std::set<std::string> told;
    for (const TaskResult& task : result.tasks)
        for (const CheckResult& check : task.checks)
            for (const Diagnostic& each : shaderErrorsIn(check))
                if (told.insert(each.file).second)
                    errors.push_back(each);
    return errors;
}

/// A check's message; of a shader's errors only whose they are, for they are told at their lines.
std::string messageOf(const CheckResult& check) {
    if (const auto errors = shaderErrorsIn(check); !errors.empty())
        return errors.front().file + " does not compile";
    return check.message.substr(0, check.message.find_last_not_of(" \n") + 1);
}

/// What a task lost, in one sentence: the mistake where it is known, else its first lost check.
std::string lossOf(const TaskResult& task) {
    if (task.recognised)
        return task.recognised->says;
    for (const CheckResult& check : task.checks)
        if (!check.full())
            return check.title + ": " + messageOf(check);
    return "";
}

std::string hintOf(const TaskResult& task) {
    for (const CheckResult& check : task.checks)
        if (!check.full() && !check.hint.empty())
            return check.hint;
    return "";
}

/// Where nothing is there yet, or nothing compiles, one sentence serves for all checks.
bool sameForAll(const TaskResult& task) {
    return task.status == Status::notImplemented || task.status == Status::buildError;
}

std::string lossesInCell(const TaskResult& task) {
    std::string cell;
    if (task.recognised)
        cell = "→ " + escapedMarkdown(task.recognised->says) + "<br>";
    std::size_t lost = 0;
    for (const CheckResult& check : task.checks) {
        if (check.full() || check.status == Status::pending)
            continue;
        if (sameForAll(task))
            return escapedMarkdown(messageOf(check));
        if (++lost <= kMostChecksShown)
            cell += escapedMarkdown(fmt::format("{}: {}", check.title, messageOf(check))) + "<br>";
    }
    if (lost > kMostChecksShown)
        cell += fmt::format("and {} more<br>", lost - kMostChecksShown);
    if (const std::string hint = hintOf(task); !hint.empty())
        cell += "*Hint:* " + escapedMarkdown(hint);
    return cell;
}

std::string errorSection(const AssignmentResult& result) {
    const auto errors = errorsOf(result);
    if (errors.empty())
        return "";
    const Diagnostic& error = errors.front();
    const auto source = quoted(error, 100);
    std::string text = placeOf(error) + error.message;
    if (!source.line.empty())
        text += "\n" + source.line + "\n" + source.caret;
    const std::string hint = hintFor(error);
    return "The first compile error:\n\n" + fencedMarkdown(text) +
           (hint.empty() ? "" : "\n" + escapedMarkdown(hint) + "\n") + "\n";
}

/// What a person gives later counts neither way. Sums of thirds may be a little short.
double pointsToPass(const AssignmentResult& result, double passFrom) {
    return passFrom / 100 * result.automaticPoints();
}

bool passes(const AssignmentResult& result, double passFrom) {
    return result.points() >= pointsToPass(result, passFrom) - 1e-9;
}

std::string sectionOf(const AssignmentResult& result, double passFrom) {
    std::string text =
        fmt::format("## {} {}: {}\n\n", result.assignment, escapedMarkdown(result.title),
                    scoreText(result.points(), result.maxPoints()));
    if (result.graderFailed())
        return text + kFault;
    text += fmt::format(
        "{} from {} points on.\n\n",
        passes(result, passFrom) ? "Passed; the check passes" : "Not passed yet; the check passes",
        showPoints(pointsToPass(result, passFrom)));
    text += errorSection(result);
    text += "| | task | points | what was lost |\n|---|---|---|---|\n";
    for (const TaskResult& task : result.tasks)
        text += fmt::format("| {} | {} | {} | {} |\n", symbolOf(task.status),
                            escapedMarkdown(task.title), scoreText(task.points, task.maxPoints),
                            lossesInCell(task));
    for (const std::string& notice : result.notices)
        text += "\n* " + escapedMarkdown(notice);
    return text + (result.notices.empty() ? "\n" : "\n\n");
}

std::string unusedSection(const Changes& changes) {
    if (changes.unused.empty() && !changes.unusedCut)
        return "";
    std::string text =
        "### Not used\n\nOnly the files that a handout lists under \"Hand in\" are graded, by the "
        "course's own grader, tests and workflows. These changes had no effect on the result:\n\n";
    const std::size_t shown = std::min(changes.unused.size(), kMostUnusedShown);
    for (std::size_t i = 0; i < shown; ++i)
        text += "* " + codeMarkdown(changes.unused[i]) + "\n";
    if (changes.unusedCut)
        text += "* and many more\n";
    else if (shown < changes.unused.size())
        text += fmt::format("* and {} more\n", changes.unused.size() - shown);
    return text + "\n";
}

/// Annotations of one kind, of which only so many are shown.
class Kind {
public:
    explicit Kind(const char* name) : name_(name) {}
    void add(const std::string& properties, const std::string& text) {
        if (count_++ < kMostAnnotations)
            lines_ += fmt::format("::{} {}::{}\n", name_, properties, commandData(text));
    }
    const std::string& lines() const { return lines_; }

private:
    const char* name_;
    int count_ = 0;
    std::string lines_;
};

/// The student's file of that name, relative to `files`: in the assignment's folder, or in that of
/// the one which it is inherited from. Empty for any other.
fs::path studentFile(const fs::path& files, const std::string& assignment,
                     const std::string& name) {
    if (name.empty() || fs::path(name).is_absolute() || name.find("..") != std::string::npos)
        return {};
    const auto isThere = [&](const fs::path& folder) {
        return typeOf(folder / name) == fs::file_type::regular;
    };
    if (isThere(files / assignment))
        return fs::path(assignment) / name;
    for (const fs::path& folder : entriesOf(files))
        if (isThere(folder))
            return folder.filename() / name;
    return {};
}

std::string placeProperties(const fs::path& file, int line, int column) {
    if (file.empty())
        return "";
    std::string text = "file=" + commandProperty((fs::path("assignments") / file).string());
    if (line > 0)
        text += fmt::format(",line={}", line);
    if (column > 0)
        text += fmt::format(",col={}", column);
    return text + ",";
}

/// Where a task's region begins in a folder below `files`; empty where it has none.
std::string regionIn(const fs::path& folder, const fs::path& files, const std::string& task) {
    if (!fs::is_directory(folder))
        return "";
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string text = entry.is_regular_file() ? readFile(entry.path()) : "";
        if (const int line = lineOfRegion(text, task); line > 0)
            return placeProperties(fs::relative(entry.path(), files), line, 0);
    }
    return "";
}

/// The same in the assignment's folder, or else in that of the one which it inherits the file from.
std::string regionProperties(const fs::path& files, const std::string& assignment,
                             const std::string& task) {
    std::vector<fs::path> folders = entriesOf(files);
    folders.insert(folders.begin(), files / assignment);
    for (const fs::path& folder : folders)
        if (const std::string place = regionIn(folder, files, task); !place.empty())
            return place;
    return "";
}

bool isLostToAShader(const TaskResult& task) {
    return task.status == Status::buildError &&
           std::any_of(task.checks.begin(), task.checks.end(),
                       [](const CheckResult& check) { return !shaderErrorsIn(check).empty(); });
}

/// What each task lost, at its region; nothing where a shader's error says it all.
void annotateTasks(const AssignmentResult& result, const fs::path& files, Kind& warnings,
                   Kind& notices) {
    for (const TaskResult& task : result.tasks) {
        if (task.status == Status::pass || task.status == Status::pending ||
            result.status != "graded" || isLostToAShader(task))
            continue;
        Kind& kind = task.status == Status::notImplemented ? notices : warnings;
        const std::string hint = hintOf(task);
        kind.add(regionProperties(files, result.assignment, task.id) +
                     fmt::format("title={}", commandProperty(fmt::format(
                                                 "{}: {}", task.title,
                                                 scoreText(task.points, task.maxPoints)))),
                 lossOf(task) + (hint.empty() ? "" : "\nHint: " + hint));
    }
}

}  // namespace

bool PullRequestResult::passed() const {
    return changes.misplaced.empty() &&
           std::all_of(results.begin(), results.end(),
                       [&](const AssignmentResult& each) { return passes(each, passFrom); });
}

bool PullRequestResult::graderFailed() const {
    return std::any_of(results.begin(), results.end(),
                       [](const AssignmentResult& each) { return each.graderFailed(); });
}

std::string summaryOfFault() {
    return std::string("## Not graded\n\n") + kFault;
}

std::string summaryOf(const PullRequestResult& graded) {
    std::string text;
    if (graded.results.empty())
        text =
            "## Nothing to grade\n\nThis pull request changes no file that a handout lists under "
            "\"Hand in\".\n\n";
    if (!graded.changes.misplaced.empty()) {
        text += "The check does not pass, for what is in the wrong place is not graded:\n\n";
        for (const std::string& each : graded.changes.misplaced)
            text += "* " + escapedMarkdown(each) + "\n";
        text += "\n";
    }
    for (const AssignmentResult& each : graded.results)
        text += sectionOf(each, graded.passFrom);
    for (const std::string& notice : graded.changes.notices)
        text += "* " + escapedMarkdown(notice) + "\n";
    if (!graded.changes.notices.empty())
        text += "\n";
    return text + unusedSection(graded.changes);
}

std::string annotationsOf(const PullRequestResult& graded, const fs::path& files) {
    Kind errors("error"), warnings("warning"), notices("notice");
    // These first: what is beyond the most that are shown is lost.
    for (const std::string& each : graded.changes.misplaced)
        errors.add("title=in the wrong place", each);
    for (const std::string& each : graded.changes.notices)
        notices.add("title=not taken", each);
    if (!graded.changes.unused.empty())
        notices.add("title=not used",
                    fmt::format("changes to {} have no effect on the result{}",
                                graded.changes.unused.front(),
                                graded.changes.unused.size() == 1
                                    ? ""
                                    : fmt::format(", nor those to {} other files",
                                                  graded.changes.unused.size() - 1)));
    for (const AssignmentResult& result : graded.results) {
        const auto addAll = [&](Kind& kind, const std::vector<Diagnostic>& all, const char* title) {
            for (const Diagnostic& each : all)
                kind.add(placeProperties(studentFile(files, result.assignment, each.file),
                                         each.line, each.column) +
                             "title=" + title,
                         each.message);
        };
        addAll(errors, errorsOf(result), "does not compile");
        annotateTasks(result, files, warnings, notices);
        if (!result.full())  // what is lost comes first
            addAll(warnings, diagnosticsOf(result, "warning"), "the compiler warns");
    }
    return errors.lines() + warnings.lines() + notices.lines();
}

}  // namespace grader
