#include "TerminalReport.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
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
        case Status::pass:
            return {"✓", "\033[32m"};
        case Status::partial:
            return {"◐", "\033[33m"};
        case Status::notImplemented:
            return {"○", "\033[36m"};
        case Status::skipped:
            return {"–", "\033[36m"};
        case Status::graderError:
            return {"!", "\033[35m"};
        default:
            return {"✗", "\033[31m"};
    }
}

bool startsCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

/// Columns that a text of UTF-8 takes; every sign of ours takes one.
std::size_t columns(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), startsCharacter));
}

/// Bytes of the first `most` columns.
std::size_t bytesOf(const std::string& text, std::size_t most) {
    std::size_t at = 0;
    for (std::size_t seen = 0; at < text.size(); ++at)
        if (startsCharacter(text[at]) && seen++ == most)
            break;
    return at;
}

/// The text in at most so many columns; "…" stands for the rest.
std::string shortened(const std::string& text, std::size_t most) {
    return columns(text) <= most ? text : text.substr(0, bytesOf(text, most - 1)) + "…";
}

/// Whether a terminal would obey instead of show: control characters, in UTF-8 the second set too,
/// and those that turn the direction of writing.
bool steers(const std::string& sign) {
    static const char* turning[] = {"\u200E", "\u200F", "\u202A", "\u202B", "\u202C", "\u202D",
                                    "\u202E", "\u2066", "\u2067", "\u2068", "\u2069"};
    const auto first = static_cast<unsigned char>(sign[0]);
    return first < 32 || first == 127 ||
           (first == 0xC2 && static_cast<unsigned char>(sign[1]) < 0xA0) ||
           std::find(std::begin(turning), std::end(turning), sign) != std::end(turning);
}

/// Text of a student's making must not steer the terminal.
std::string harmless(std::string text) {
    for (auto bad = firstInvalidUtf8(text); bad != std::string::npos;
         bad = firstInvalidUtf8(text, bad))
        text[bad] = '?';
    std::string safe;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t size = bytesOf(text.substr(i, 5), 1);
        const std::string sign = text.substr(i, size);
        safe += steers(sign) ? " " : sign;
        i += size;
    }
    return safe;
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
        out.paragraph("    ✗ ", placeOf(each) + each.message);
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

/// `told`: shader errors that were written before.
void writeTask(Writer& out, const TaskResult& task, std::set<std::string>& told) {
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
        if (check.status == Status::buildError) {
            writeShaderError(out, check, told);
            continue;
        }
        out.paragraph(fmt::format("    {} ", markOf(check.status).symbol),
                      check.title + ": " + check.message);
        if (!check.hint.empty() && check.hint != hint && check.status != Status::notImplemented &&
            check.status != Status::skipped) {
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
    std::set<std::string> told;
    for (const TaskResult& task : result.tasks)
        writeTask(out, task, told);
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
