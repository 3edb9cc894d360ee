#include "report/HtmlReport.h"

#include <fmt/format.h>

#include <algorithm>

#include "ImageModule.h"
#include "report/Html.h"
#include "report/HtmlCheck.h"
#include "report/ReportAssets.h"
#include "report/Words.h"

namespace grader {

namespace {

/// Columns of a source line that a page shows.
constexpr std::size_t kSourceColumns = 400;

std::string anchor(const AssignmentResult& result, const TaskResult& task) {
    return escaped(result.assignment + "." + task.id);
}

std::string diagnosticOf(const Diagnostic& diagnostic) {
    std::string html = fmt::format("<li><p><code class=\"place\">{}</code>{}: {}</p>",
                                   escaped(placeOf(diagnostic)), escaped(diagnostic.severity),
                                   escaped(diagnostic.message));
    if (const QuotedSource source = quoted(diagnostic, kSourceColumns); !source.line.empty())
        html += fmt::format("<pre class=\"source\">{}\n<span class=\"caret\">{}</span></pre>",
                            escaped(source.line), source.caret);
    if (const std::string hint = hintFor(diagnostic); !hint.empty())
        html += "<p class=\"hint\">Hint: " + escaped(hint) + "</p>";
    return html + "</li>\n";
}

std::string diagnosticsOf(const AssignmentResult& result) {
    std::string errors, warnings;
    int warned = 0;
    for (const Diagnostic& each : result.diagnostics) {
        const bool error = each.severity == "error";
        (error ? errors : warnings) += diagnosticOf(each);
        warned += !error;
    }
    std::string html;
    if (!errors.empty())
        html += "<article class=\"compiler\"><h3>To be mended first</h3>\n<ol>" + errors +
                "</ol></article>\n";
    if (warned > 0)
        html += fmt::format(
            "<details class=\"compiler warnings\"><summary>{} {} of the compiler</summary>\n"
            "<ol>{}</ol></details>\n",
            warned, warned == 1 ? "warning" : "warnings", warnings);
    return html;
}

std::string recognisedOf(const TaskResult& task) {
    if (!task.recognised)
        return "";
    const Recognised& mistake = *task.recognised;
    std::string html =
        "<aside class=\"recognised\"><p class=\"says\">" + escaped(mistake.says) + "</p>";
    if (!mistake.section.empty())
        html += "<p>Read section <b>" + escaped(mistake.section) + "</b> of the notes again.</p>";
    return html + "</aside>\n";
}

/// Tests of which there is nothing more to say than their titles, behind one line.
std::string titlesOf(const std::vector<const CheckResult*>& tests, Status status,
                     const std::string& what) {
    if (tests.empty())
        return "";
    std::string html = fmt::format(
        "<details class=\"titles\"><summary>{}<span class=\"title\">{} {} "
        "{}</span></summary>\n<ul>",
        markOf(status), tests.size(), tests.size() == 1 ? "check" : "checks", what);
    for (const CheckResult* each : tests)
        html += "<li>" + escaped(each->title) + "</li>\n";
    return html + "</ul></details>\n";
}

std::vector<const CheckResult*> checksOf(const TaskResult& task, const std::string& kind,
                                         bool full) {
    std::vector<const CheckResult*> checks;
    for (const CheckResult& each : task.checks)
        if (each.kind == kind && each.full() == full)
            checks.push_back(&each);
    return checks;
}

/// Frames first: they are to be looked at. Of the tests the first lies open.
std::string lostChecksOf(const TaskResult& task, const fs::path& folder) {
    std::string html, hint;
    const auto add = [&](const CheckResult& check, bool open) {
        open = open && check.status != Status::notImplemented;
        html += lostCheck(check, folder, open, !open || check.hint != hint);
        if (open)
            hint = check.hint;
    };
    for (const CheckResult* frame : checksOf(task, "frame", false))
        add(*frame, true);
    const auto tests = checksOf(task, "test", false);
    if (task.status == Status::notImplemented)
        return html + titlesOf(tests, task.status, "to come");
    for (const CheckResult* test : tests)
        add(*test, test == tests.front());
    return html;
}

std::string fullChecksOf(const TaskResult& task, const fs::path& folder) {
    std::string frames;
    for (const CheckResult* each : checksOf(task, "frame", true))
        frames += fullFrame(*each, folder);
    return titlesOf(checksOf(task, "test", true), Status::pass, "passed") +
           (frames.empty() ? "" : "<div class=\"full-frames\">" + frames + "</div>\n");
}

std::string taskOf(const TaskResult& task, const AssignmentResult& result, const fs::path& folder) {
    std::string html = fmt::format(
        "<article class=\"task {}\" id=\"{}\">\n<h3>{}<span class=\"title\">{} <code>{}</code>"
        "</span><span class=\"points\">{}</span></h3>\n{}\n",
        judge::toString(task.status), anchor(result, task), markOf(task.status),
        escaped(task.title), escaped(task.id), scoreText(task.points, task.maxPoints),
        barOf(task.points, task.maxPoints));
    if (task.status == Status::notImplemented)
        html += "<p class=\"message\">" + escaped(task.checks.front().message) + "</p>\n";
    if (task.status == Status::pending)
        html += "<p class=\"message\">" + escaped(task.checks.back().message) + "</p>\n";
    return html + recognisedOf(task) + lostChecksOf(task, folder) + fullChecksOf(task, folder) +
           "</article>\n";
}

/// Those that lost most come first; those that lost alike stay in the handout's order.
std::vector<const TaskResult*> byLoss(const AssignmentResult& result) {
    std::vector<const TaskResult*> tasks;
    for (const TaskResult& each : result.tasks)
        tasks.push_back(&each);
    std::stable_sort(tasks.begin(), tasks.end(), [](const TaskResult* a, const TaskResult* b) {
        return a->maxPoints - a->points > b->maxPoints - b->points + 1e-9;
    });
    return tasks;
}

std::string headOf(const AssignmentResult& result) {
    std::string html = fmt::format(
        "<header class=\"head\">\n<p class=\"score\"><b>{}</b> / {}</p>\n"
        "<h2>{} <span class=\"id\">{}</span></h2>\n<p class=\"next\">{}</p>\n{}\n",
        showPoints(result.points()), showPoints(result.maxPoints()), escaped(result.title),
        escaped(result.assignment), escaped(whatNext(result)),
        barOf(result.points(), result.maxPoints()));
    if (result.status == "build_error")
        return html + "</header>\n";
    html += "<ul class=\"contents\">\n";
    for (const TaskResult& task : result.tasks)
        html += fmt::format("<li><a href=\"#{}\">{}{} <span class=\"points\">{}</span></a></li>\n",
                            anchor(result, task), markOf(task.status), escaped(task.id),
                            scoreText(task.points, task.maxPoints));
    return html + "</ul></header>\n";
}

/// What else decides a result. Where nothing was drawn, there is no renderer.
std::string footOf(const AssignmentResult& result) {
    const Environment& here = result.environment;
    std::string all;
    for (const std::string& each : {here.grader, here.compiler, here.glRenderer, here.cpu})
        all += each.empty() ? "" : escaped(each) + "; ";
    return fmt::format("<footer><p>Seed {}. {}sandbox: {}.</p></footer>\n", result.seed, all,
                       escaped(here.sandbox));
}

std::string assignmentSection(const AssignmentResult& result, const fs::path& folder) {
    std::string html = fmt::format("<section class=\"assignment\" id=\"{}\">\n{}",
                                   escaped(result.assignment), headOf(result));
    for (const std::string& notice : result.notices)
        html += "<p class=\"notice\">Note: " + escaped(notice) + "</p>\n";
    if (!result.ignoredFiles.empty())
        html += "<p class=\"notice\">Not taken: " +
                escaped(fmt::format("{}", fmt::join(result.ignoredFiles, ", "))) + "</p>\n";
    html += diagnosticsOf(result);
    if (result.status != "build_error")
        for (const TaskResult* task : byLoss(result))
            html += taskOf(*task, result, folder);
    return html + footOf(result) + "</section>\n";
}

/// Of several assignments, what each has earned.
std::string overviewOf(const std::vector<AssignmentResult>& results) {
    if (results.size() < 2)
        return "";
    std::string html = "<nav class=\"overview\" aria-label=\"Assignments\"><ul>\n";
    for (const AssignmentResult& each : results)
        html += fmt::format(
            "<li><a href=\"#{}\"><span class=\"title\">{}</span><span class=\"points\">{}</span>"
            "{}</a></li>\n",
            escaped(each.assignment), escaped(each.assignment),
            scoreText(each.points(), each.maxPoints()), barOf(each.points(), each.maxPoints()));
    return html + "</ul></nav>\n";
}

std::string hashOf(std::string_view text) {
    const std::string digits = sha256(std::string(text));
    std::string bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2)
        bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return "'sha256-" + base64(bytes) + "'";
}

/// Only this page's own script and style run, whatever a student's text manages to become.
std::string policy(bool live) {
    return fmt::format(
        "default-src 'none'; img-src data: blob:{}; style-src {}; script-src {}; base-uri 'none'; "
        "form-action 'none'",
        live ? " file:" : "", hashOf(kReportStyle), hashOf(kReportScript));
}

void writeMasks(CheckResult& check, const std::string& assignment, const fs::path& folder) {
    for (FeatureResult& feature : check.features)
        if (!feature.mask.empty()) {
            feature.maskPath = fmt::format("{}/{}.{}.mask.png", assignment, check.id, feature.id);
            writePicture(folder / feature.maskPath, feature.mask);
        }
}

/// A frame that is the reference is written once and copied.
void writePicturesOf(CheckResult& check, const std::string& assignment, const fs::path& folder) {
    FramePictures& pictures = *check.pictures;
    for (const char* name : {"submission", "reference", "difference"})
        check.imagePaths[name] = fmt::format("{}/{}.{}.png", assignment, check.id, name);
    const auto file = [&](const char* name) { return folder / check.imagePaths.at(name); };
    writePicture(file("submission"), pictures.submission);
    if (pictures.submission.rgba == pictures.reference.rgba)
        fs::copy_file(file("submission"), file("reference"), fs::copy_options::overwrite_existing);
    else
        writePicture(file("reference"), pictures.reference);
    pictures.difference = differenceOf(pictures.submission, pictures.reference);
    writePicture(file("difference"), pictures.difference);
}

}  // namespace

void writeReportPictures(std::vector<AssignmentResult>& results, const fs::path& folder) {
    for (AssignmentResult& result : results)
        for (TaskResult& task : result.tasks)
            for (CheckResult& check : task.checks)
                if (check.pictures) {
                    writePicturesOf(check, result.assignment, folder);
                    writeMasks(check, result.assignment, folder);
                }
}

void copyPictures(std::vector<AssignmentResult>& results, const std::set<std::string>& open,
                  const fs::path& from, const fs::path& to) {
    const auto copy = [&](const std::string& path) {
        fs::create_directories((to / path).parent_path());
        fs::copy_file(from / path, to / path, fs::copy_options::overwrite_existing);
    };
    for (AssignmentResult& result : results)
        for (TaskResult& task : result.tasks)
            for (CheckResult& check : task.checks) {
                if (!open.contains(check.id)) {
                    std::erase_if(check.imagePaths,
                                  [](const auto& each) { return each.first != "submission"; });
                    for (FeatureResult& feature : check.features)
                        feature.maskPath.clear();
                }
                for (const auto& [name, path] : check.imagePaths)
                    copy(path);
                for (const FeatureResult& feature : check.features)
                    if (!feature.maskPath.empty())
                        copy(feature.maskPath);
            }
}

std::string htmlReport(const std::vector<AssignmentResult>& results, const fs::path& folder,
                       const std::string& version) {
    const std::string title =
        results.size() == 1 ? results[0].assignment + " " + results[0].title : "Report";
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<title>{}</title>\n<style>{}</style></head><body{}>\n<main>\n"
        "<h1 class=\"unseen\">Report</h1>\n",
        policy(!version.empty()), escaped(title), kReportStyle,
        version.empty() ? "" : fmt::format(" data-version=\"{}\"", version));
    html += overviewOf(results);
    for (const AssignmentResult& each : results)
        html += assignmentSection(each, folder);
    return html + fmt::format(
                      "</main>\n<template id=\"viewer\">{}</template>\n"
                      "<script>{}</script></body></html>\n",
                      kReportViewer, kReportScript);
}

void writeReport(std::vector<AssignmentResult>& results, const fs::path& folder) {
    writeReportPictures(results, folder);
    writeFile(folder / "index.html", htmlReport(results, folder));
}

}  // namespace grader
