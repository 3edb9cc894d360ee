#include "TerminalReport.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace grader {

namespace {

constexpr std::size_t kMostDiagnostics = 5;
constexpr const char* kReset = "\033[0m";

struct Mark {
    const char* symbol;
    const char* colour;
};

Mark markOf(Status status) {
    switch (status) {
        case Status::pass: return {"✓", "\033[32m"};
        case Status::partial: return {"◐", "\033[33m"};
        case Status::notImplemented: return {"○", "\033[36m"};
        case Status::skipped: return {"–", "\033[36m"};
        case Status::graderError: return {"!", "\033[35m"};
        default: return {"✗", "\033[31m"};
    }
}

/// Columns that a text of UTF-8 takes; every sign of ours takes one.
std::size_t columns(const std::string& text) {
    std::size_t count = 0;
    for (const unsigned char each : text)
        count += (each & 0xC0) != 0x80;
    return count;
}

/// Text of a student's making must not steer the terminal.
std::string harmless(const std::string& text) {
    std::string safe;
    for (const char each : text)
        safe += static_cast<unsigned char>(each) < 32 || each == 127 ? ' ' : each;
    return safe;
}

class Writer {
public:
    explicit Writer(const TerminalStyle& style) : style_(style) {}

    std::string painted(const std::string& text, const char* colour) const {
        return style_.colours ? colour + text + kReset : text;
    }
    /// Left text, then right text at the margin.
    void row(const std::string& left, const std::string& right, const char* colour = "") {
        const auto width = static_cast<std::size_t>(style_.width);
        const std::size_t used = columns(left) + columns(right);
        out_ << (*colour ? painted(left, colour) : left)
             << std::string(used < width ? width - used : 1, ' ') << right << "\n";
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
        }
        out_ << line << "\n";
    }
    std::string take() { return out_.str(); }

private:
    TerminalStyle style_;
    std::ostringstream out_;
};

std::string scoreText(double points, double most) {
    return showPoints(points) + " / " + showPoints(most);
}

void writeDiagnostics(Writer& out, const AssignmentResult& result) {
    std::size_t errors = 0;
    for (const Diagnostic& each : result.diagnostics) {
        if (each.severity != "error" || ++errors > kMostDiagnostics)
            continue;
        const std::string place = each.file.empty() ? ""
                                  : each.line == 0  ? each.file + ": "
                                                    : fmt::format("{}:{}:{}: ", each.file, each.line,
                                                                  each.column);
        out.paragraph("    ✗ ", place + each.message);
        if (const std::string hint = hintFor(each); !hint.empty())
            out.paragraph("      hint: ", hint);
    }
    if (errors > kMostDiagnostics)
        out.paragraph("    ", fmt::format("and {} more errors; the first is the one to mend first",
                                          errors - kMostDiagnostics));
}

void writeTask(Writer& out, const TaskResult& task) {
    const Mark mark = markOf(task.status);
    out.row(fmt::format("  {} {:<16} {}", mark.symbol, task.id, task.title),
            scoreText(task.points, task.maxPoints), mark.colour);
    if (task.status == Status::notImplemented) {
        // One sentence serves for all checks when they say the same.
        out.paragraph("      ", task.checks.front().message);
        return;
    }
    std::string hint;
    for (const CheckResult& check : task.checks) {
        if (check.full())
            continue;
        out.paragraph(fmt::format("    {} ", markOf(check.status).symbol),
                      check.title + ": " + check.message);
        if (!check.hint.empty() && check.hint != hint &&
            check.status != Status::notImplemented && check.status != Status::skipped) {
            out.paragraph("      hint: ", check.hint);
            hint = check.hint;
        }
    }
}

}  // namespace

std::string showPoints(double points) {
    // Cut, not rounded up: what is not everything must not read as everything.
    return fmt::format("{:g}", std::floor(points * 10 + 1e-6) / 10);
}

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
        writeDiagnostics(out, result);
        return out.take();
    }
    for (const TaskResult& task : result.tasks)
        writeTask(out, task);
    if (result.graderFailed())
        out.paragraph("  ! ", "The grader itself failed above; that is not your mistake. Please "
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
