#include "report/TerminalReport.h"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "report/PlainText.h"
#include "report/TerminalPictures.h"
#include "report/TerminalWriter.h"
#include "report/Words.h"

namespace grader {

namespace {

constexpr std::size_t kMostDiagnostics = 5;
constexpr int kPreviewIndent = 6;
constexpr int kPreviewColumns = 36;

const char* colourOf(Status status) {
    switch (status) {
        case Status::pass:
            return kGreen;
        case Status::partial:
            return "\033[33m";
        case Status::notImplemented:
        case Status::skipped:
        case Status::pending:
            return "\033[36m";
        case Status::graderError:
            return "\033[35m";
        default:
            return kRed;
    }
}

/// The first messages of the compiler that are of one severity.
void writeDiagnostics(TerminalWriter& out, const AssignmentResult& result,
                      const std::string& severity) {
    std::size_t found = 0;
    for (const Diagnostic& each : result.diagnostics)
        if (each.severity == severity && ++found <= kMostDiagnostics)
            out.diagnostic(each);
    if (found > kMostDiagnostics)
        out.paragraph("    ", fmt::format("and {} more {}s; the first is the one to mend first",
                                          found - kMostDiagnostics, severity));
}

/// A shader that does not compile fails every check that uses it: its log is told once.
void writeShaderError(TerminalWriter& out, const CheckResult& check, std::set<std::string>& told) {
    if (!told.insert(check.message).second)
        return;
    std::istringstream lines(check.message);
    const char* lead = "    ✗ ";
    for (std::string line; std::getline(lines, line); lead = "      ")
        out.paragraph(lead, line);
}

void writeRecognised(TerminalWriter& out, const Recognised& recognised) {
    out.paragraph(
        "    → ",
        recognised.says +
            (recognised.section.empty() ? "" : fmt::format(" (section {})", recognised.section)));
}

void writeFeatures(TerminalWriter& out, const CheckResult& frame) {
    for (const FeatureResult& each : frame.features)
        if (each.points < each.maxPoints && !each.message.empty())
            out.paragraph(each.points > 0 ? "      ◐ " : "      ✗ ",
                          each.title + ": " + each.message);
}

/// `hint`: the one that was written last; it is not said twice in a row.
void writeLost(TerminalWriter& out, const CheckResult& check, bool pictures, std::string& hint) {
    out.paragraph(fmt::format("    {} ", symbolOf(check.status)),
                  check.title + ": " + check.message);
    writeFeatures(out, check);
    if (!check.hint.empty() && check.hint != hint && check.status != Status::notImplemented &&
        check.status != Status::skipped) {
        out.paragraph("      hint: ", check.hint);
        hint = check.hint;
    }
    if (pictures && check.pictures)
        out.lines(previewOf(check.pictures->submission, check.pictures->reference, kPreviewColumns,
                            kPreviewIndent));
}

/// `told`: shader errors that were written before.
void writeTask(TerminalWriter& out, const TaskResult& task, bool pictures,
               std::set<std::string>& told) {
    out.row(fmt::format("  {} {:<16} {}", symbolOf(task.status), task.id, task.title),
            scoreText(task.points, task.maxPoints), colourOf(task.status));
    if (task.recognised)
        writeRecognised(out, *task.recognised);
    if (task.checks.empty())
        return;  // none that may be seen
    if (task.status == Status::notImplemented || task.status == Status::pending) {
        // One sentence serves for all checks when they say the same.
        out.paragraph("      ", task.status == Status::pending ? task.checks.back().message
                                                               : task.checks.front().message);
        return;
    }
    std::string hint;
    for (const CheckResult& check : task.checks) {
        if (check.full())
            continue;
        if (check.status == Status::buildError)
            writeShaderError(out, check, told);
        else
            writeLost(out, check, pictures, hint);
    }
}

}  // namespace

std::string terminalReport(const AssignmentResult& result, const TerminalStyle& style) {
    TerminalWriter out(style);
    const std::string heading = result.assignment + "  " + result.title;
    const std::string score = scoreText(result.points(), result.maxPoints());
    if (result.notStarted())
        out.row(heading + ": not started, begin with " + result.tasks.front().id, score);
    else
        out.row(heading, score, kBold);
    for (const std::string& notice : result.notices)
        out.paragraph("  note: ", notice);
    if (!result.ignoredFiles.empty())
        out.paragraph("  not taken: ", fmt::format("{}", fmt::join(result.ignoredFiles, ", ")));
    if (result.notStarted())
        return out.take();
    if (result.status == "build_error") {
        out.paragraph("  ", "Nothing could be checked before this is mended:");
        writeDiagnostics(out, result, "error");
        return out.take();
    }
    if (!result.full())  // what GCC warns of without being asked is often why
        writeDiagnostics(out, result, "warning");
    std::set<std::string> told;
    for (const TaskResult& task : result.tasks)
        writeTask(out, task, style.pictures, told);
    if (result.graderFailed())
        out.paragraph("  ! ",
                      "The grader itself failed above; that is not your mistake. Please "
                      "report it with the sentence shown.");
    return out.take();
}

std::string terminalSummary(const std::vector<AssignmentResult>& results,
                            const TerminalStyle& style) {
    double points = 0, most = 0;
    for (const AssignmentResult& each : results) {
        points += each.points();
        most += each.maxPoints();
    }
    TerminalWriter out(style);
    out.row("all assignments", scoreText(points, most), kBold);
    return out.take();
}

}  // namespace grader
