#include "HtmlReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "ImageModule.h"
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
    EXPECT_LT(page.find("75 / 100"), page.find("look-at")) << "the score stands on top";
    EXPECT_THAT(page, HasSubstr("expected (1, 2, 3), got (3, 2, 1)"));
    EXPECT_THAT(page, HasSubstr("Hint: Turn up too."));
    EXPECT_THAT(page, HasSubstr("sandbox: bubblewrap"));
}

TEST(HtmlReport, HostileTextStaysText) {
    AssignmentResult result = sampleResult();
    result.title = result.notices.emplace_back(kHostile);
    result.ignoredFiles = {kHostile};
    result.diagnostics = {{kHostile, 1, 1, "error", kHostile}};
    result.environment.glRenderer = kHostile;
    for (TaskResult& task : result.tasks) {
        task.title = kHostile;
        for (CheckResult& check : task.checks)
            check.title = check.message = check.hint = kHostile;
    }
    const std::string page = pageOf(result);
    EXPECT_THAT(page, Not(HasSubstr("<script")));
    EXPECT_THAT(page, Not(HasSubstr("\x1b")));
    EXPECT_EQ(allOf(page, "&lt;script").size(), 17u) << "each of them is shown, and nothing twice";
    EXPECT_THAT(page, HasSubstr(kHarmless));
}

TEST(HtmlReport, ADiagnosticNamesAsMuchOfThePlaceAsIsKnown) {
    AssignmentResult result = sampleResult();
    result.diagnostics = {{"Camera.cpp", 3, 4, "error", "one"}, {"", 0, 0, "error", "two"}};
    EXPECT_THAT(pageOf(result), HasSubstr("Camera.cpp:3:4: error: one\nerror: two\n"));
}

TEST(HtmlReport, NeedsNothingElse) {
    const Tree tree;
    std::vector<AssignmentResult> results = {withFrame()};
    writeReportPictures(results, tree.path());
    const std::string page = htmlReport(results, tree.path());
    EXPECT_THAT(page, Not(HasSubstr("http")));
    EXPECT_THAT(page, Not(HasSubstr("<script")));
    EXPECT_THAT(page, Not(HasSubstr("<link")));
    EXPECT_THAT(page, Not(HasSubstr("url(")));
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
