#include "watch/WatchText.h"

#include <algorithm>
#include <cmath>

#include "Diagnostics.h"
#include "ResultDocument.h"
#include "report/Words.h"

namespace grader {

namespace {

constexpr std::size_t kMostLogLines = 4;  // of a shader's compiler

std::string signedPoints(double points) {
    return (points < 0 ? "-" : "+") + showPoints(std::abs(points));
}

std::vector<Diagnostic> errorsOf(const Json& result) {
    std::vector<Diagnostic> errors;
    for (const Json& each : result.at("build").at("diagnostics"))
        if (each.at("severity") == "error")
            errors.push_back(diagnosticFrom(each));
    return errors;
}

void writeErrors(TerminalWriter& out, const Json& result) {
    const auto errors = errorsOf(result);
    if (errors.empty())
        return;
    out.diagnostic(errors.front());
    if (errors.size() > 1)
        out.paragraph("    ", fmt::format("and {} more; the first is the one to mend first",
                                          errors.size() - 1));
}

/// A shader's log has a line for each error; the first tell enough.
void writeLog(TerminalWriter& out, const std::string& log) {
    std::istringstream lines(log);
    std::size_t written = 0;
    for (std::string line; written < kMostLogLines && std::getline(lines, line); ++written)
        out.paragraph(written == 0 ? "    ✗ " : "      ", line);
}

const Json& taskOf(const Json& result, const Json& check) {
    for (const Json& task : result.at("tasks"))
        for (const Json& each : task.at("checks"))
            if (&each == &check)
                return task;
    return result.at("tasks").at(0);
}

void writeNext(TerminalWriter& out, const Json& result) {
    const Json* check = firstLost(result);
    if (!check) {
        out.paragraph("  ", "Everything is done: full marks.", kGreen);
        return;
    }
    const Json& task = taskOf(result, *check);
    const std::string status = check->at("status");
    const std::string sign = symbolOf(judge::statusFromString(status));
    if (status == "build_error") {
        out.paragraph("  ", fmt::format("{}: does not compile", task.at("id")));
        writeLog(out, check->at("message"));
        return;
    }
    if (status == "not_implemented") {
        out.paragraph("  " + sign + " ",
                      fmt::format("next: {}, {} ({} points)", task.at("id"), task.at("title"),
                                  showPoints(task.at("max_points"))));
        return;
    }
    out.paragraph("  " + sign + " ", fmt::format("{}: {}: {}", task.at("id"), check->at("title"),
                                                 check->at("message")));
    if (task.contains("recognised"))
        out.paragraph("    → ", task.at("recognised").at("says"));
}

}  // namespace

std::string verdictText(const Json& result, const std::vector<Change>& changes,
                        const Baseline& baseline, const TerminalStyle& style) {
    TerminalWriter out(style);
    const std::string heading = fmt::format("{}  {}", result.at("assignment"), result.at("title"));
    if (result.at("status") == "build_error") {
        out.row(heading + ": does not compile", "", kBold);
        writeErrors(out, result);
        if (baseline.points() > 0)
            out.paragraph("  ", fmt::format("When it compiled last it stood at {}.",
                                            scoreText(baseline.points(), result.at("max_points"))));
        return out.take();
    }
    out.row(heading, scoreText(result.at("points"), result.at("max_points")), kBold);
    for (const Change& each : changes) {
        out.paragraph(fmt::format("  {}: ", signedPoints(each.points)), each.sentence,
                      each.points > 0 ? kGreen : kRed);
        if (!each.message.empty())
            out.paragraph("      ", each.message.substr(0, each.message.find('\n')));
    }
    if (result.at("status") == "grader_error")
        out.paragraph("  ! ",
                      "The grader itself failed below; that is not your mistake. Please report it "
                      "with the sentence shown.");
    else if (changes.empty() && !doesNotCompile(result))
        out.paragraph("  ", "No points earned or lost.");
    writeNext(out, result);
    return out.take();
}

std::string hintText(const Json& result, const TerminalStyle& style) {
    TerminalWriter out(style);
    if (result.at("status") == "build_error") {
        writeErrors(out, result);
        return out.take();
    }
    const Json* check = firstLost(result);
    if (!check) {
        out.paragraph("  ", "Nothing is lost, so there is no hint.");
        return out.take();
    }
    if (check->at("status") == "build_error") {
        writeLog(out, check->at("message"));
        return out.take();
    }
    const std::string hint = check->at("hint");
    out.paragraph("  hint: ",
                  hint.empty() ? fmt::format("there is none for \"{}\"; the handout's section on "
                                             "{} lists the usual errors",
                                             check->at("title"), taskOf(result, *check).at("id"))
                               : hint);
    return out.take();
}

std::string taskText(const Json& result, const Json& task, const std::string& place,
                     const TerminalStyle& style) {
    TerminalWriter out(style);
    const std::string id = task.at("id");
    out.row(fmt::format("  {} {:<16} {}", symbolOf(judge::statusFromString(task.at("status"))), id,
                        task.at("title")),
            scoreText(task.at("points"), task.at("max_points")));
    out.paragraph("    ", fmt::format("{}: TODO({})", place.empty() ? "in the code" : place, id));
    out.paragraph("    ",
                  fmt::format("assignments/{}/README.md: `{}`", result.at("assignment"), id));
    const Json& checks = task.at("checks");
    const auto lost = std::find_if(checks.begin(), checks.end(), [](const Json& check) {
        return check.at("status") != "pass" && check.at("status") != "not_implemented";
    });
    if (lost == checks.end())
        return out.take();
    if (lost->at("status") == "build_error")
        writeLog(out, lost->at("message"));
    else
        out.paragraph("    ✗ ", fmt::format("{}: {}", lost->at("title"), lost->at("message")));
    return out.take();
}

}  // namespace grader
