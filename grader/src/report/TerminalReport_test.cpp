#include "report/TerminalReport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "testing/Results.h"

namespace {

using namespace grader;
using testing::HasSubstr;
using testing::Not;
using testing_help::check;
using testing_help::sampleResult;
using testing_help::task;

std::string reportOf(const AssignmentResult& result, bool colours = false) {
    return terminalReport(result, {colours, 80});
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

/// Characters, not bytes.
std::size_t widthOf(const std::string& line) {
    std::size_t count = 0;
    for (const unsigned char byte : line)
        count += (byte & 0xC0) != 0x80;
    return count;
}

testing::AssertionResult fits(const std::string& report) {
    for (const std::string& line : linesOf(report))
        if (widthOf(line) > 80)
            return testing::AssertionFailure() << widthOf(line) << " columns: " << line;
    return testing::AssertionSuccess();
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

AssignmentResult withMessage(const std::string& message) {
    AssignmentResult result = sampleResult();
    result.tasks[1].checks[1].message = message;
    return result;
}

TEST(TerminalReport, HasARowPerTaskAndASentencePerLostCheck) {
    const std::string report = reportOf(sampleResult());
    const auto lines = linesOf(report);
    ASSERT_EQ(lines.size(), 5u) << report;
    EXPECT_TRUE(lines[0].starts_with("07-camera  Camera"));
    EXPECT_TRUE(lines[0].ends_with(" 75 / 100"));
    EXPECT_TRUE(lines[1].starts_with("  ✓ look-at"));
    EXPECT_TRUE(lines[1].ends_with(" 60 / 60"));
    EXPECT_TRUE(lines[2].starts_with("  ◐ rotate-up"));
    EXPECT_EQ(lines[3], "    ✗ title of RotateUp.B: expected (1, 2, 3), got (3, 2, 1)");
    EXPECT_EQ(lines[4], "      hint: Turn up too.");
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(widthOf(lines[static_cast<std::size_t>(i)]), 80u);
}

TEST(TerminalReport, NeverExceedsEightyColumns) {
    AssignmentResult result = sampleResult();
    result.title = "A title that is very long, for an assignment that has a very long title indeed";
    result.notices = {std::string(300, 'n'), "Größe äöüß€ " + std::string(90, 'x')};
    for (int i = 0; i < 40; ++i)
        result.ignoredFiles.push_back("a-file-with-some-name-" + std::to_string(i) + ".cpp");
    result.tasks[0].title = std::string(100, 't');
    result.tasks[0].id = std::string(70, 'i');
    std::string wide;
    for (int i = 0; i < 200; ++i)
        wide += "é";
    result.tasks[1].checks[1].message = wide + " " + std::string(79, 'm') + " short " + wide;
    result.tasks[1].checks[1].hint = std::string(500, 'h');
    EXPECT_TRUE(fits(reportOf(result)));
    result.status = "build_error";
    result.diagnostics = {{std::string(120, 'f'), 1, 2, "error", std::string(400, 'e')}};
    EXPECT_TRUE(fits(reportOf(result)));
    result.status = "graded";
    for (TaskResult& each : result.tasks)
        each.status = Status::notImplemented;
    EXPECT_TRUE(fits(reportOf(result)));
}

TEST(TerminalReport, LongWordsAreBrokenAndNothingIsLost) {
    const std::string word(250, 'w');
    EXPECT_EQ(count(reportOf(withMessage(word)), "w"), 250u);
    const std::string report = reportOf(withMessage(std::string(75, 'a') + " b"));
    EXPECT_TRUE(fits(report));
    EXPECT_EQ(count(report, "a"), count(reportOf(withMessage("b")), "a") + 75);
}

TEST(TerminalReport, APlaceThatIsCutKeepsItsPoints) {
    AssignmentResult result = sampleResult();
    result.tasks[0].title = std::string(100, 't');
    const std::string line = linesOf(reportOf(result))[1];
    EXPECT_EQ(widthOf(line), 80u);
    EXPECT_TRUE(line.ends_with("t… 60 / 60")) << line;
}

TEST(TerminalReport, TextOfAStudentsMakingDoesNotSteerTheTerminal) {
    const std::string report =
        reportOf(withMessage("\x1b[2Jcleared\x07 \x9b"
                             "31m raw, \u009b"
                             "31m second set,\r\nback \x7f, \u202Eturned, \xff."));
    for (const char* bad : {"\x1b", "\x07", "\x7f", "\r", "\u202E", "\u009b", "\xff"})
        EXPECT_THAT(report, Not(HasSubstr(bad)));
    for (const char* good : {"cleared", "turned", "second set"})
        EXPECT_THAT(report, HasSubstr(good));
    for (std::size_t i = 0; i < report.size(); ++i)
        EXPECT_TRUE(static_cast<unsigned char>(report[i]) >= 32 || report[i] == '\n') << i;
    EXPECT_EQ(firstInvalidUtf8(report), std::string::npos);
}

TEST(TerminalReport, NamesOfFilesAndTitlesDoNotEither) {
    AssignmentResult result = sampleResult();
    result.ignoredFiles = {"a\x1b[31m.cpp", "b\nc"};
    result.status = "build_error";
    result.diagnostics = {{"x\x1b.cpp", 1, 1, "error", "\x1b[0m"}};
    EXPECT_THAT(reportOf(result), Not(HasSubstr("\x1b")));
}

TEST(TerminalReport, OrdinaryForeignTextStays) {
    EXPECT_THAT(reportOf(withMessage("Größe 3 € \u4e2d \U0001F600 “so”")),
                HasSubstr("Größe 3 € \u4e2d \U0001F600 “so”"));
}

TEST(TerminalReport, ColoursOnlyWhereWanted) {
    EXPECT_THAT(reportOf(sampleResult(), false), Not(HasSubstr("\033")));
    const std::string report = reportOf(sampleResult(), true);
    EXPECT_EQ(count(report, "\033[32m"), 1u);
    EXPECT_EQ(count(report, "\033[0m"), 3u) << "every colour is switched off again";
}

TEST(TerminalReport, AnAssignmentThatWasNotStartedTakesOneLine) {
    AssignmentResult result = sampleResult();
    result.tasks = {task("rotate-right", Status::notImplemented,
                         {check("A.A", Status::notImplemented, 0, 60, "`a` is not implemented")}),
                    task("rotate-up", Status::notImplemented,
                         {check("B.B", Status::notImplemented, 0, 40, "`b` is not implemented")})};
    const std::string report = reportOf(result);
    ASSERT_EQ(linesOf(report).size(), 1u) << report;
    EXPECT_TRUE(report.starts_with("07-camera  Camera: not started, begin with rotate-right"));
    EXPECT_TRUE(report.ends_with(" 0 / 100\n"));

    result.notices = {"Camera.cpp is missing: graded with the starter's file"};
    result.ignoredFiles = {"camera.cpp"};
    const std::string told = reportOf(result);
    EXPECT_NE(told.find("note: Camera.cpp is missing"), std::string::npos) << told;
    EXPECT_NE(told.find("not taken: camera.cpp"), std::string::npos) << told;
}

TEST(TerminalReport, ATaskOfWhichNoCheckMayBeSeenIsALine) {
    AssignmentResult result = sampleResult();
    result.tasks[1] = task("rotate-up", Status::notImplemented, {});
    EXPECT_NE(reportOf(result).find("rotate-up"), std::string::npos);
}

TEST(TerminalReport, AnUnfilledTaskTakesOneSentence) {
    AssignmentResult result = sampleResult();
    result.tasks[1] =
        task("rotate-up", Status::notImplemented,
             {check("B.A", Status::notImplemented, 0, 20, "`b` is not there", "hint"),
              check("B.B", Status::notImplemented, 0, 20, "`b` is not there", "hint")});
    const std::string report = reportOf(result);
    EXPECT_EQ(count(report, "`b` is not there"), 1u);
    EXPECT_THAT(report, Not(HasSubstr("hint")));
    EXPECT_THAT(report, HasSubstr("  ○ rotate-up"));
}

TEST(TerminalReport, AHintIsSaidOnceForNeighbours) {
    AssignmentResult result = sampleResult();
    result.tasks[1].checks.push_back(result.tasks[1].checks[1]);
    EXPECT_EQ(count(reportOf(result), "hint: Turn up too."), 1u);
    result.tasks[1].checks.back().hint = "Another.";
    EXPECT_EQ(count(reportOf(result), "hint: "), 2u);
}

TEST(TerminalReport, AtMostFiveErrorsTheFirstFirst) {
    AssignmentResult result = sampleResult();
    result.status = "build_error";
    result.diagnostics.push_back({"Camera.cpp", 1, 1, "warning", "a warning"});
    for (int i = 1; i <= 8; ++i)
        result.diagnostics.push_back({"Camera.cpp", i, 3, "error", "mistake " + std::to_string(i)});
    const std::string report = reportOf(result);
    EXPECT_THAT(report, HasSubstr("Nothing could be checked before this is mended:"));
    EXPECT_THAT(report, HasSubstr("    ✗ Camera.cpp:1:3: mistake 1\n"));
    EXPECT_LT(report.find("mistake 1"), report.find("mistake 2"));
    EXPECT_THAT(report, HasSubstr("mistake 5"));
    EXPECT_THAT(report, Not(HasSubstr("mistake 6")));
    EXPECT_THAT(report, HasSubstr("and 3 more errors"));
    EXPECT_THAT(report, Not(HasSubstr("a warning")));
    EXPECT_THAT(report, Not(HasSubstr("look-at"))) << "no tasks that nobody could check";
}

TEST(TerminalReport, AnErrorHasItsHint) {
    AssignmentResult result = sampleResult();
    result.status = "build_error";
    result.diagnostics = {{"Camera.cpp", 9, 2, "error", "expected ';' before '}' token"}};
    EXPECT_THAT(reportOf(result), HasSubstr("      hint: a semicolon is missing"));
}

TEST(TerminalReport, TheCompilersWarningsAreToldWhereSomethingIsLost) {
    AssignmentResult result = sampleResult();
    result.diagnostics = {{"Camera.cpp", 9, 1, "warning",
                           "no return statement in function returning non-void [-Wreturn-type]",
                           "}"}};
    const std::string report = reportOf(result);
    EXPECT_THAT(report, HasSubstr("    ! Camera.cpp:9:1: warning: no return statement"));
    EXPECT_THAT(report, HasSubstr("      hint: every way through a function"));
    EXPECT_LT(report.find("warning: "), report.find("look-at")) << "before what it may explain";
    for (TaskResult& each : result.tasks)
        each.status = Status::pass;
    EXPECT_THAT(reportOf(result), Not(HasSubstr("warning: "))) << "all is well";
}

TEST(TerminalReport, NoticesAndIgnoredFilesAreSaid) {
    AssignmentResult result = sampleResult();
    result.notices = {"Camera.cpp is missing: graded with the starter's file"};
    result.ignoredFiles = {"extra.cpp", "tests/"};
    EXPECT_THAT(reportOf(result), HasSubstr("note: Camera.cpp is missing"));
    EXPECT_THAT(reportOf(result), HasSubstr("not taken: extra.cpp, tests/"));
}

TEST(TerminalReport, TheGradersOwnFaultIsNoStudents) {
    AssignmentResult result = sampleResult();
    result.tasks[1].checks[1].status = Status::graderError;
    EXPECT_THAT(reportOf(result), HasSubstr("that is not your mistake"));
    EXPECT_THAT(reportOf(sampleResult()), Not(HasSubstr("that is not your mistake")));
}

TEST(TerminalReport, TheLineOfAnErrorIsShownWithACaret) {
    AssignmentResult result = sampleResult();
    result.status = "build_error";
    result.diagnostics = {{"Camera.cpp", 9, 12, "error", "wrong", "    return nope\x1b[2J;"}};
    EXPECT_THAT(reportOf(result),
                HasSubstr("            return nope [2J;\n" + std::string(19, ' ') + "^\n"));
    result.diagnostics[0].source = std::string(300, 's');
    result.diagnostics[0].column = 250;
    EXPECT_TRUE(fits(reportOf(result)));
    EXPECT_THAT(reportOf(result), HasSubstr("^\n"));
}

TEST(TerminalReport, ARecognisedMistakeStandsRightBelowItsTask) {
    AssignmentResult result = sampleResult();
    result.tasks[1].recognised = {{"turned"}, "You turn\x1b about the wrong axis.", "7.2"};
    const auto lines = linesOf(reportOf(result));
    ASSERT_EQ(lines.size(), 6u);
    EXPECT_TRUE(lines[2].starts_with("  ◐ rotate-up"));
    EXPECT_EQ(lines[3], "    → You turn about the wrong axis. (section 7.2)");
    result.tasks[1].recognised->section.clear();
    EXPECT_THAT(reportOf(result), Not(HasSubstr("section")));
}

TEST(TerminalReport, EachLostFeatureOfAFrameHasItsSentence) {
    AssignmentResult result = sampleResult();
    result.tasks[1].checks[1].features = {{"a", "the lamp", 3, 3, "nothing to say", {}},
                                          {"b", "the shadow", 1, 4, "half of it is there", {}},
                                          {"c", "the glint", 0, 2, "it is missing", {}},
                                          {"d", "the haze", 0, 2, "", {}}};
    const std::string report = reportOf(result);
    EXPECT_THAT(report, HasSubstr("\n      ◐ the shadow: half of it is there\n"
                                  "      ✗ the glint: it is missing\n"));
    EXPECT_THAT(report, Not(HasSubstr("the lamp")));
    EXPECT_THAT(report, Not(HasSubstr("the haze"))) << "there is nothing to say of it";
}

TEST(TerminalReport, PicturesStandBelowLostFramesWhereWanted) {
    AssignmentResult result = sampleResult();
    for (TaskResult& each : result.tasks)
        for (CheckResult& frame : each.checks)
            frame.pictures = {{4, 4, std::vector<std::uint8_t>(64, 9)},
                              {4, 4, std::vector<std::uint8_t>(64, 8)},
                              {},
                              {}};
    TerminalStyle style{false, 80, true};
    const std::string report = terminalReport(result, style);
    EXPECT_EQ(count(report, "reference\n"), 1u) << "full frames show none";
    EXPECT_EQ(count(report, "▀"), 2u * 36 * 18);
    EXPECT_EQ(count(reportOf(result), "▀"), 0u);
}

TEST(TerminalSummary, AddsUpInOneLine) {
    const std::string line = terminalSummary({sampleResult(), sampleResult()}, {false, 80});
    EXPECT_EQ(linesOf(line).size(), 1u);
    EXPECT_TRUE(line.starts_with("all assignments"));
    EXPECT_TRUE(line.ends_with(" 150 / 200\n"));
}

}  // namespace
