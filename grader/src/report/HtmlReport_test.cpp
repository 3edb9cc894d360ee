#include "report/HtmlReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <regex>

#include "ImageModule.h"
#include "report/HtmlCheck.h"
#include "report/ReportAssets.h"
#include "testing/Results.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::HasSubstr;
using testing::Not;
using testing_help::sampleResult;
using testing_help::Tree;

const std::string kHostile = "<script src=\"http://evil\">alert('&')</script>\x1b[2J";
const std::string kHarmless =
    "&lt;script src=&quot;http://evil&quot;&gt;alert('&amp;')&lt;/script&gt; [2J";

std::string pageOf(const AssignmentResult& result, const fs::path& folder = "/nonexistent") {
    return htmlReport({result}, folder);
}

std::vector<std::string> allOf(const std::string& text, const char* pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), regex);
         it != std::sregex_iterator(); ++it)
        found.push_back(it->str());
    return found;
}

AssignmentResult withFrame() {
    AssignmentResult result = sampleResult();
    CheckResult& frame = result.tasks[1].checks[1];
    frame.id = "pole";
    frame.kind = "frame";
    frame.pictures.emplace();
    frame.pictures->submission = {2, 1, {10, 20, 30, 255, 40, 50, 60, 255}};
    frame.pictures->reference = {2, 1, {10, 20, 30, 255, 140, 150, 160, 255}};
    frame.pictures->score.outliers = 0.125;
    frame.pictures->score.meanError = 0.0625;
    frame.pictures->score.score = 0.25;
    return result;
}

TEST(HtmlReport, HasScoreTasksAndReasons) {
    const std::string page = pageOf(sampleResult());
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_LT(page.find("<b>75</b> / 100"), page.find("look-at")) << "the score stands on top";
    EXPECT_THAT(page, HasSubstr("expected (1, 2, 3), got (3, 2, 1)"));
    EXPECT_THAT(page, HasSubstr("Hint: Turn up too."));
    EXPECT_THAT(page, HasSubstr("sandbox: bubblewrap"));
}

/// All that a student can put a text of their own into.
AssignmentResult withHostileText() {
    AssignmentResult result = withFrame();
    result.title = result.notices.emplace_back(kHostile);
    result.ignoredFiles = {kHostile};
    result.diagnostics = {{kHostile, 1, 1, "error", kHostile, kHostile},
                          {kHostile, 1, 1, "warning", kHostile, kHostile}};
    result.environment.glRenderer = kHostile;
    for (TaskResult& task : result.tasks) {
        task.title = kHostile;
        task.recognised = {{"id"}, kHostile, kHostile};
        for (CheckResult& check : task.checks) {
            check.title = check.message = check.hint = kHostile;
            check.pictures.reset();
            check.comparison = {kHostile, {{1}}, {{2}}, 0};
            check.features = {{"id", kHostile, 0, 1, kHostile, {}}};
        }
    }
    return result;
}

TEST(HtmlReport, HostileTextStaysText) {
    const std::string page = pageOf(withHostileText());
    EXPECT_EQ(allOf(page, "<script").size(), 1u) << "the page's own";
    EXPECT_EQ(allOf(page, "</style").size(), 1u);
    EXPECT_THAT(page, Not(HasSubstr("\x1b")));
    EXPECT_EQ(allOf(page, "src=\"http").size(), 0u);
    EXPECT_THAT(page, HasSubstr(kHarmless));
    // Page title; title, next step, notice, file not taken, renderer; three of each diagnostic; of
    // each task the title and the mistake; of a lost check all its texts; of full ones the title.
    EXPECT_EQ(allOf(page, "&lt;script").size(), 1u + 5 + 2 * 3 + 2 * 3 + 6 + 2);
}

TEST(HtmlReport, HostileBytesAreText) {
    AssignmentResult result = sampleResult();
    result.tasks[1].checks[1].message = "\u202Eturned \xff \x9b one\ntwo";
    EXPECT_THAT(pageOf(result), HasSubstr(" turned ? ? one\ntwo"));
}

TEST(HtmlReport, ADiagnosticNamesAsMuchOfThePlaceAsIsKnown) {
    AssignmentResult result = sampleResult();
    result.diagnostics = {{"Camera.cpp", 3, 4, "error", "one"}, {"", 0, 0, "error", "two"}};
    EXPECT_THAT(pageOf(result), HasSubstr("Camera.cpp:3:4: </code>error: one<"));
    EXPECT_THAT(pageOf(result), HasSubstr("></code>error: two<"));
}

TEST(HtmlReport, ADiagnosticShowsItsLineWithACaret) {
    AssignmentResult result = sampleResult();
    result.diagnostics = {{"Camera.cpp", 3, 7, "error", "one", "  if (a < b"}};
    EXPECT_THAT(pageOf(result), HasSubstr("  if (a &lt; b\n<span class=\"caret\">      ^</span>"));
}

TEST(HtmlReport, WhatDoesNotCompileHasNoTasks) {
    AssignmentResult result = sampleResult();
    result.status = "build_error";
    EXPECT_THAT(pageOf(result), Not(HasSubstr("look-at")));
    EXPECT_THAT(pageOf(result), HasSubstr("mend the first error"));
}

TEST(HtmlReport, AnUnfilledTaskSaysSoOnceAndNamesItsChecks) {
    AssignmentResult result = sampleResult();
    result.tasks[1].status = Status::notImplemented;
    for (CheckResult& each : result.tasks[1].checks) {
        each.status = Status::notImplemented;
        each.message = "`b` is not there";
    }
    const std::string page = pageOf(result);
    EXPECT_EQ(allOf(page, "`b` is not there").size(), 1u);
    EXPECT_THAT(page, HasSubstr("2 checks to come"));
    EXPECT_THAT(page, HasSubstr("title of RotateUp.B"));
}

TEST(HtmlReport, WhatLostMostComesFirst) {
    AssignmentResult result = sampleResult();
    result.tasks.push_back(result.tasks[0]);
    result.tasks[2].id = "worst";
    result.tasks[2].points = 0;
    const std::string page = pageOf(result);
    const auto at = [&](const char* id) { return page.find("id=\"07-camera." + std::string(id)); };
    EXPECT_LT(at("worst"), at("rotate-up"));
    EXPECT_LT(at("rotate-up"), at("look-at"));
}

TEST(HtmlReport, ARecognisedMistakeSendsBackToTheNotes) {
    AssignmentResult result = sampleResult();
    EXPECT_THAT(pageOf(result), Not(HasSubstr("of the notes again")));
    result.tasks[1].recognised = {{"a", "b"}, "You turn the wrong way.", "7.2"};
    const std::string page = pageOf(result);
    EXPECT_THAT(page, HasSubstr("You turn the wrong way."));
    EXPECT_THAT(page, HasSubstr("Read section <b>7.2</b> of the notes again"));
}

TEST(HtmlReport, ItsPolicyForbidsAllThatIsNotItsOwn) {
    const std::string page = pageOf(sampleResult());
    EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data: blob:; style-src 'sha256-"));
    EXPECT_THAT(page, Not(HasSubstr("unsafe-inline")));
    EXPECT_THAT(page, HasSubstr("<style>" + std::string(kReportStyle) + "</style>"));
    EXPECT_THAT(page, HasSubstr("<script>" + std::string(kReportScript) + "</script>"));
    EXPECT_GT(kReportScript.size(), 1000u);
    EXPECT_GT(kReportViewer.size(), 1000u);
}

TEST(HtmlReport, NeedsNothingElse) {
    const Tree tree;
    std::vector<AssignmentResult> results = {withFrame()};
    writeReportPictures(results, tree.path());
    const std::string page = htmlReport(results, tree.path());
    EXPECT_THAT(page, Not(HasSubstr("http:")));
    EXPECT_THAT(page, Not(HasSubstr("https:")));
    EXPECT_THAT(page, Not(HasSubstr("<link")));
    EXPECT_THAT(page, Not(HasSubstr("url(")));
    EXPECT_THAT(page, Not(HasSubstr("@import")));
    const auto sources = allOf(page, "src=\"[^\"]{0,40}");
    EXPECT_EQ(sources.size(), 3u);
    for (const std::string& source : sources)
        EXPECT_TRUE(source.starts_with("src=\"data:image/png;base64,iVBORw0KGgo")) << source;
}

TEST(HtmlReport, PicturesStandBesideEachOtherWithTheirNumbers) {
    const Tree tree;
    std::vector<AssignmentResult> results = {withFrame()};
    writeReportPictures(results, tree.path());
    const CheckResult& frame = results[0].tasks[1].checks[1];
    EXPECT_EQ(frame.imagePaths.at("submission"), "07-camera/pole.submission.png");
    EXPECT_EQ(readPicture(tree / frame.imagePaths.at("reference")).rgba,
              frame.pictures->reference.rgba);
    EXPECT_EQ(readPicture(tree / frame.imagePaths.at("difference")).width, 2);
    const std::string page = htmlReport(results, tree.path());
    EXPECT_LT(page.find("yours"), page.find(">reference<"));
    EXPECT_THAT(page, HasSubstr("12.500 % of the pixels differ"));
    EXPECT_THAT(page, HasSubstr("mean error 0.0625"));
    EXPECT_THAT(page, HasSubstr("score 0.250"));
}

TEST(HtmlReport, AFeatureHasItsShareItsSentenceAndItsMask) {
    const Tree tree;
    std::vector<AssignmentResult> results = {withFrame()};
    CheckResult& frame = results[0].tasks[1].checks[1];
    const Picture mask{2, 1, {255, 255, 255, 255, 0, 0, 0, 255}};
    frame.features = {{"glint", "the glint", 1, 4, "a quarter of it is there", mask},
                      {"rest", "the rest", 2, 2, "", {}},
                      {"haze", "the haze", 0, 2, "", {}}};
    writeReportPictures(results, tree.path());
    EXPECT_EQ(readPicture(tree / frame.features[0].maskPath).rgba, mask.rgba);
    const std::string page = htmlReport(results, tree.path());
    EXPECT_THAT(page, HasSubstr("a quarter of it is there"));
    EXPECT_THAT(page, HasSubstr("the rest"));
    EXPECT_THAT(page, Not(HasSubstr("the haze"))) << "there is nothing to say of it";
    EXPECT_THAT(page, HasSubstr("1 / 4"));
    EXPECT_THAT(page, HasSubstr("width=\"25.0\""));
    EXPECT_EQ(allOf(page, "<img class=\"mask\"").size(), 1u);
    EXPECT_EQ(allOf(page, "<li class=\"feature\" tabindex=\"0\"").size(), 1u);
}

TEST(HtmlReport, AFullFrameIsClosedAndHasItsPicturesToo) {
    const Tree tree;
    std::vector<AssignmentResult> results = {withFrame()};
    results[0].tasks[1].checks[1].status = Status::pass;
    writeReportPictures(results, tree.path());
    const std::string page = htmlReport(results, tree.path());
    EXPECT_THAT(page, HasSubstr("<details class=\"check full pass\">"));
    EXPECT_EQ(allOf(page, "<img class=").size(), 3u);
}

std::string matrixOf(const Comparison& comparison, const std::string& name) {
    const std::string html = comparisonOf(comparison);
    const auto from = html.find("aria-label=\"" + name + "\"");
    return html.substr(from, html.find("</table>", from) - from);
}

TEST(Matrices, WrongEntriesAreMarkedInYours) {
    const Comparison comparison{"m", {{1, 0.5}, {0, 2}}, {{1, -0.5}, {0, 2.0009}}, 0.001};
    const std::string yours = matrixOf(comparison, "yours");
    EXPECT_THAT(yours, HasSubstr("<tr><td>1.000</td><td class=\"wrong\">-0.500<"));
    EXPECT_THAT(yours, HasSubstr("<tr><td>0.000</td><td>2.001</td></tr>"));
    EXPECT_THAT(matrixOf(comparison, "expected"), Not(HasSubstr("wrong")));
}

TEST(Matrices, ShowAsManyDecimalsAsTellThemApart) {
    EXPECT_THAT(matrixOf({"v", {{1}, {2}}, {{3}, {2}}, 0}, "yours"), HasSubstr(">3<"));
    EXPECT_THAT(matrixOf({"v", {{1.5}}, {{1.50004}}, 0}, "yours"), HasSubstr(">1.50004<"));
    EXPECT_THAT(matrixOf({"v", {{0}}, {{-1e-12}}, 1}, "yours"), HasSubstr(">0.000<"));
}

TEST(Matrices, WhatIsNoNumberOrNotThereIsWrong) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(allOf(matrixOf({"v", {{1}, {2}}, {{nan}, {nan}}, 9}, "yours"), "class=.wrong").size(),
              2u);
    EXPECT_EQ(allOf(matrixOf({"v", {{1}}, {{1, 1}, {1}}, 9}, "yours"), "class=.wrong").size(), 2u);
}

TEST(HtmlReport, ChecksWithoutPicturesWriteNone) {
    const Tree tree;
    std::vector<AssignmentResult> results = {sampleResult()};
    writeReportPictures(results, tree.path());
    EXPECT_TRUE(fs::is_empty(tree.path()));
}

TEST(PictureCache, GivesWhatTheFileHoldsAndNoticesAChange) {
    const Tree tree;
    const Picture picture{2, 1, {1, 2, 3, 255, 4, 5, 6, 255}};
    writePicture(tree / "a.png", picture);
    for (int i = 0; i < 2; ++i) {
        const Picture read = readPictureCached(tree / "a.png", tree / "cache");
        EXPECT_EQ(read.width, 2);
        EXPECT_EQ(read.rgba, picture.rgba);
    }
    for (const auto& entry : fs::directory_iterator(tree / "cache"))
        fs::resize_file(entry.path(), 11);
    EXPECT_EQ(readPictureCached(tree / "a.png", tree / "cache").rgba, picture.rgba)
        << "a broken entry is made anew";
    writePicture(tree / "a.png", {1, 1, {9, 9, 9, 255}});
    EXPECT_EQ(readPictureCached(tree / "a.png", tree / "cache").width, 1);
}

}  // namespace
