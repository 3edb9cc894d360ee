#include "report/TerminalReport.h"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "report/PlainText.h"
#include "report/TerminalPictures.h"
#include "report/Words.h"

namespace grader {

namespace {

constexpr std::size_t kMostDiagnostics = 5;
constexpr const char* kReset = "\033[0m";
constexpr int kPreviewIndent = 6;
constexpr int kPreviewColumns = 36;

const char* colourOf(Status status) {
    switch (status) {
        case Status::pass:
            return "\033[32m";
        case Status::partial:
            return "\033[33m";
        case Status::notImplemented:
        case Status::skipped:
        case Status::pending:
            return "\033[36m";
        case Status::graderError:
            return "\033[35m";
        default:
            return "\033[31m";
    }
}

class Writer {
public:
    explicit Writer(const TerminalStyle& style) : style_(style) {}

    std::string painted(const std::string& text, const char* colour) const {
        return style_.colours ? colour + text + kReset : text;
    }
    /// Left text, cut where it must be, then right text at the margin.
    void row(const std::string& left, const std::string& right, const char* colour = "") {
        const auto width = static_cast<std::size_t>(style_.width) - columns(right);
        const std::string text = shortened(harmless(left), width - 1);
        out_ << (*colour ? painted(text, colour) : text) << std::string(width - columns(text), ' ')
             << right << "\n";
    }
    /// `lead` once, then words wrapped and indented below each other.
    void paragraph(const std::string& lead, const std::string& text) {
        const std::size_t indent = columns(lead);
        const auto width = static_cast<std::size_t>(style_.width);
        std::istringstream words(harmless(text));
        std::string line = lead;
        bool empty = true;
        for (std::string word; words >> word;) {
            if (!empty && columns(line) + 1 + columns(word) > width) {
                out_ << line << "\n";
                line = std::string(indent, ' ');
                empty = true;
            }
            line += (empty ? "" : " ") + word;
            empty = false;
            while (columns(line) > width) {  // one word that is longer than a line
                const std::size_t cut = bytesOf(line, width);
                out_ << line.substr(0, cut) << "\n";
                line = std::string(indent, ' ') + line.substr(cut);
            }
        }
        out_ << line << "\n";
    }
    /// Text of our own making, as it is.
    void lines(const std::string& text) { out_ << text; }
    std::string take() { return out_.str(); }

private:
    TerminalStyle style_;
    std::ostringstream out_;
};

void writeSource(Writer& out, const Diagnostic& diagnostic, const TerminalStyle& style) {
    const std::string indent(8, ' ');
    const auto source =
        quoted(diagnostic, static_cast<std::size_t>(style.width) - indent.size() - 1);
    if (source.line.empty())
        return;
    out.lines(indent + source.line + "\n");
    if (!source.caret.empty())
        out.lines(indent + source.caret + "\n");
}

void writeDiagnostics(Writer& out, const AssignmentResult& result, const TerminalStyle& style) {
    std::size_t errors = 0;
    for (const Diagnostic& each : result.diagnostics) {
        if (each.severity != "error" || ++errors > kMostDiagnostics)
            continue;
        out.paragraph("    ✗ ", placeOf(each) + each.message);
        writeSource(out, each, style);
        if (const std::string hint = hintFor(each); !hint.empty())
            out.paragraph("      hint: ", hint);
    }
    if (errors > kMostDiagnostics)
        out.paragraph("    ", fmt::format("and {} more errors; the first is the one to mend first",
                                          errors - kMostDiagnostics));
}

/// A shader that does not compile fails every check that uses it: its log is told once.
void writeShaderError(Writer& out, const CheckResult& check, std::set<std::string>& told) {
    if (!told.insert(check.message).second)
        return;
    std::istringstream lines(check.message);
    const char* lead = "    ✗ ";
    for (std::string line; std::getline(lines, line); lead = "      ")
        out.paragraph(lead, line);
}

void writeRecognised(Writer& out, const Recognised& recognised) {
    out.paragraph(
        "    → ",
        recognised.says +
            (recognised.section.empty() ? "" : fmt::format(" (section {})", recognised.section)));
}

void writeFeatures(Writer& out, const CheckResult& frame) {
    for (const FeatureResult& each : frame.features)
        if (each.points < each.maxPoints)
            out.paragraph(each.points > 0 ? "      ◐ " : "      ✗ ",
                          each.title + ": " + each.message);
}

/// `hint`: the one that was written last; it is not said twice in a row.
void writeLost(Writer& out, const CheckResult& check, bool pictures, std::string& hint) {
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
void writeTask(Writer& out, const TaskResult& task, bool pictures, std::set<std::string>& told) {
    out.row(fmt::format("  {} {:<16} {}", symbolOf(task.status), task.id, task.title),
            scoreText(task.points, task.maxPoints), colourOf(task.status));
    if (task.recognised)
        writeRecognised(out, *task.recognised);
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
    Writer out(style);
    const std::string heading = result.assignment + "  " + result.title;
    const std::string score = scoreText(result.points(), result.maxPoints());
    if (result.notStarted()) {
        out.row(heading + ": not started, begin with " + result.tasks.front().id, score);
        return out.take();
    }
    out.row(heading, score, "\033[1m");
    for (const std::string& notice : result.notices)
        out.paragraph("  note: ", notice);
    if (!result.ignoredFiles.empty())
        out.paragraph("  not taken: ", fmt::format("{}", fmt::join(result.ignoredFiles, ", ")));
    if (result.status == "build_error") {
        out.paragraph("  ", "The code does not compile, so nothing could be checked:");
        writeDiagnostics(out, result, style);
        return out.take();
    }
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
    Writer out(style);
    out.row("all assignments", scoreText(points, most), "\033[1m");
    return out.take();
}

}  // namespace grader
