#include "HtmlReport.h"

#include <fmt/format.h>

#include "ImageModule.h"
#include "TerminalReport.h"

namespace grader {

namespace {

const char* kStyle = R"css(
:root { color-scheme: light dark; --line: #8884; --good: #2a7d4f; --part: #9a6b00; --bad: #b3372f;
        --calm: #3b6ea8; }
@media (prefers-color-scheme: dark) {
  :root { --good: #5cc48d; --part: #e0b04a; --bad: #ff8078; --calm: #85b6ec; } }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 64rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; margin-bottom: .2rem; } h1 .score { float: right; }
h2 { font-size: 1.1rem; border-bottom: 1px solid var(--line); margin-top: 2rem; }
h2 .score { float: right; font-weight: normal; }
.pass { color: var(--good); } .partial { color: var(--part); }
.fail, .crash, .timeout, .memory, .output, .tampered, .build_error { color: var(--bad); }
.not_implemented, .skipped { color: var(--calm); } .grader_error { color: #a4b; }
table { border-collapse: collapse; width: 100%; } td { padding: .3rem .6rem .3rem 0;
  border-bottom: 1px solid var(--line); vertical-align: top; } td.points { text-align: right;
  white-space: nowrap; } td.status { white-space: nowrap; }
.message { overflow-wrap: anywhere; } .hint { opacity: .8; font-style: italic; }
.pictures { display: flex; gap: .8rem; flex-wrap: wrap; margin: .5rem 0; }
figure { margin: 0; flex: 1 1 14rem; } figure img { width: 100%; image-rendering: pixelated;
  border: 1px solid var(--line); } figcaption, .numbers, footer { font-size: .85rem; opacity: .8; }
pre { overflow-x: auto; background: #8881; padding: .6rem; }
@media print { body { margin: 0; } table, figure { break-inside: avoid; } }
)css";

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char each : text) {
        switch (each) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += static_cast<unsigned char>(each) < 32 && each != '\n' ? ' ' : each;
        }
    }
    return safe;
}

std::string base64(const std::string& bytes) {
    static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group =
                group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string scoreText(double points, double most) {
    return fmt::format("{} / {}", showPoints(points), showPoints(most));
}

std::string figure(const std::string& path, const fs::path& folder, const std::string& caption) {
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\">"
        "<figcaption>{0}</figcaption></figure>\n",
        escaped(caption), base64(readFile(folder / path)));
}

std::string picturesOf(const CheckResult& check, const fs::path& folder) {
    if (!check.pictures || check.imagePaths.empty())
        return "";
    const FrameScore& score = check.pictures->score;
    std::string html = "<div class=\"pictures\">\n";
    html += figure(check.imagePaths.at("submission"), folder, "yours: " + check.title);
    html += figure(check.imagePaths.at("reference"), folder, "reference");
    html += figure(check.imagePaths.at("difference"), folder, "difference (white: wrong)");
    if (check.maxPoints == 0)
        return html + "</div><p class=\"numbers\">Shown to look at; no points depend on it.</p>\n";
    html += fmt::format(
        "</div><p class=\"numbers\">{:.3f} % of the pixels differ; mean error {:.4f} "
        "(skill {:.3f}); score {:.3f}</p>\n",
        100 * score.outliers, score.meanError, score.skill, score.score);
    return html;
}

std::string checkRow(const CheckResult& check, const fs::path& folder) {
    const std::string status = judge::toString(check.status);
    std::string html =
        fmt::format("<tr><td class=\"status {0}\">{1}</td><td>{2}", status,
                    status == "not_implemented" ? "not implemented" : status, escaped(check.title));
    if (!check.message.empty())
        html += fmt::format("<div class=\"message\">{}</div>", escaped(check.message));
    if (!check.hint.empty() && check.status != Status::notImplemented &&
        check.status != Status::buildError)
        html += fmt::format("<div class=\"hint\">Hint: {}</div>", escaped(check.hint));
    html += picturesOf(check, folder);
    return html + fmt::format("</td><td class=\"points\">{}</td></tr>\n",
                              scoreText(check.points, check.maxPoints));
}

std::string diagnosticsOf(const AssignmentResult& result) {
    if (result.diagnostics.empty())
        return "";
    std::string lines;
    for (const Diagnostic& each : result.diagnostics) {
        lines += fmt::format("{}{}: {}\n", placeOf(each), each.severity, each.message);
        if (const std::string hint = hintFor(each); !hint.empty())
            lines += "    hint: " + hint + "\n";
    }
    return "<h2>The compiler says</h2><pre>" + escaped(lines) + "</pre>\n";
}

std::string assignmentSection(const AssignmentResult& result, const fs::path& folder) {
    std::string html = fmt::format("<section><h1>{} {}<span class=\"score\">{}</span></h1>\n",
                                   escaped(result.assignment), escaped(result.title),
                                   scoreText(result.points(), result.maxPoints()));
    for (const std::string& notice : result.notices)
        html += fmt::format("<p>Note: {}</p>\n", escaped(notice));
    if (!result.ignoredFiles.empty())
        html += fmt::format("<p>Not taken: {}</p>\n",
                            escaped(fmt::format("{}", fmt::join(result.ignoredFiles, ", "))));
    if (result.status == "build_error")
        html +=
            "<p class=\"build_error\">The code does not compile, so nothing could be "
            "checked.</p>\n";
    html += diagnosticsOf(result);
    for (const TaskResult& task : result.tasks) {
        html += fmt::format(
            "<h2><span class=\"{}\">{}</span> {}<span class=\"score\">{}</span></h2>"
            "\n<table>\n",
            judge::toString(task.status), escaped(task.id), escaped(task.title),
            scoreText(task.points, task.maxPoints));
        for (const CheckResult& check : task.checks)
            html += checkRow(check, folder);
        html += "</table>\n";
    }
    const Environment& here = result.environment;
    return html + fmt::format(
                      "<footer><p>Seed {}. {}; {}; {}; {}; sandbox: {}.</p></footer>"
                      "</section>\n",
                      result.seed, escaped(here.grader), escaped(here.compiler),
                      escaped(here.glRenderer), escaped(here.cpu), escaped(here.sandbox));
}

}  // namespace

void writeReportPictures(std::vector<AssignmentResult>& results, const fs::path& folder) {
    for (AssignmentResult& result : results)
        for (TaskResult& task : result.tasks)
            for (CheckResult& check : task.checks) {
                if (!check.pictures)
                    continue;
                FramePictures& pictures = *check.pictures;
                pictures.difference = differenceOf(pictures.submission, pictures.reference);
                for (const auto& [name, picture] :
                     {std::pair{"submission", &pictures.submission},
                      std::pair{"reference", &pictures.reference},
                      std::pair{"difference", &pictures.difference}}) {
                    const std::string path =
                        fmt::format("{}/{}.{}.png", result.assignment, check.id, name);
                    writePicture(folder / path, *picture);
                    check.imagePaths[name] = path;
                }
            }
}

std::string htmlReport(const std::vector<AssignmentResult>& results, const fs::path& folder) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
        "<title>Report</title><style>" +
        std::string(kStyle) + "</style></head><body>\n";
    for (const AssignmentResult& each : results)
        html += assignmentSection(each, folder);
    return html + "</body></html>\n";
}

}  // namespace grader
