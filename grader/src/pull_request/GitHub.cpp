#include "pull_request/GitHub.h"

#include <fmt/format.h>

#include <algorithm>

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

const Diagnostic* firstError(const AssignmentResult& result) {
    const auto found =
        std::find_if(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const Diagnostic& each) { return each.severity == "error"; });
    return found == result.diagnostics.end() ? nullptr : &*found;
}

/// What a task lost, in one sentence: the mistake where it is known, else its first lost check.
std::string lossOf(const TaskResult& task) {
    if (task.recognised)
        return task.recognised->says;
    for (const CheckResult& check : task.checks)
        if (!check.full())
            return check.title + ": " + check.message;
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
            return escapedMarkdown(check.message);
        if (++lost <= kMostChecksShown)
            cell += escapedMarkdown(fmt::format("{}: {}", check.title, check.message)) + "<br>";
    }
    if (lost > kMostChecksShown)
        cell += fmt::format("and {} more<br>", lost - kMostChecksShown);
    if (const std::string hint = hintOf(task); !hint.empty())
        cell += "*Hint:* " + escapedMarkdown(hint);
    return cell;
}

std::string errorSection(const AssignmentResult& result) {
    const Diagnostic* error = firstError(result);
    if (!error)
        return "";
    const auto source = quoted(*error, 100);
    std::string text = placeOf(*error) + error->message;
    if (!source.line.empty())
        text += "\n" + source.line + "\n" + source.caret;
    const std::string hint = hintFor(*error);
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

/// Where a task's region begins among the files of the assignment.
std::string regionProperties(const fs::path& files, const std::string& assignment,
                             const std::string& task) {
    const fs::path folder = files / assignment;
    if (!fs::is_directory(folder))
        return "";
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string text = entry.is_regular_file() ? readFile(entry.path()) : "";
        const std::size_t at = text.find("BEGIN TODO(" + task + ")");
        if (at != std::string::npos)
            return placeProperties(
                fs::relative(entry.path(), files),
                1 + static_cast<int>(std::count(
                        text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')),
                0);
    }
    return "";
}

}  // namespace

bool PullRequestResult::passed() const {
    return std::all_of(results.begin(), results.end(),
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
        for (const Diagnostic& each : result.diagnostics)
            if (each.severity == "error")
                errors.add(placeProperties(studentFile(files, result.assignment, each.file),
                                           each.line, each.column) +
                               "title=does not compile",
                           each.message);
        for (const TaskResult& task : result.tasks) {
            if (task.status == Status::pass || task.status == Status::pending ||
                result.status != "graded")
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
    return errors.lines() + warnings.lines() + notices.lines();
}

}  // namespace grader
