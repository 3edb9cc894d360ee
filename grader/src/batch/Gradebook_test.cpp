#include "batch/Gradebook.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kCanvas =
    "Student,ID,SIS User ID,SIS Login ID,Section,07-camera (4711),08-perspective (4712)\r\n"
    "    Points Possible,,,,,100.00,100.00\r\n"
    "\"Doe, Jane\",12345,u1,jane@x.edu,\"A, 1\",,\r\n"
    "\"Roe, Jo\",222,u2,jo@x.edu,B,5.00,\r\n";

const std::vector<Line> kLines = {{"12345", "", "", 87.5, 100, "ok"},
                                  {"someone", "", "JO@x.edu", 40, 100, "late"},
                                  {"999", "Zed", "", 1, 100, ""}};

TEST(FillCanvas, ChangesOnlyTheCellsOfTheColumn) {
    const Filled filled = fillCanvas(CsvTable::parse(kCanvas, "g.csv"), "07-camera", kLines);
    EXPECT_EQ(filled.text,
              "Student,ID,SIS User ID,SIS Login ID,Section,07-camera (4711),08-perspective "
              "(4712)\r\n"
              "    Points Possible,,,,,100.00,100.00\r\n"
              "\"Doe, Jane\",12345,u1,jane@x.edu,\"A, 1\",87.50,\r\n"
              "\"Roe, Jo\",222,u2,jo@x.edu,B,40.00,\r\n");
    EXPECT_EQ(filled.marks, 2u);
    EXPECT_THAT(filled.remarks, ElementsAre("Zed (999) is not in the gradebook"));
}

TEST(FillCanvas, ScalesToThePointsThatCanvasCountsAndSaysSo) {
    std::string text = kCanvas;
    text.replace(text.find("100.00"), 6, "20.00");
    const Filled filled = fillCanvas(CsvTable::parse(text, "g.csv"), "07-camera", {kLines[0]});
    EXPECT_THAT(filled.text, HasSubstr("\"A, 1\",17.50,"));
    EXPECT_THAT(filled.remarks, ElementsAre("marks are scaled from 100 to the 20 points that "
                                            "Canvas counts"));
}

TEST(FillCanvas, PointsWithADecimalCommaAreReadAndOthersRefused) {
    std::string text = kCanvas;
    text.replace(text.find("100.00"), 6, "\"20,00\"");
    EXPECT_THAT(fillCanvas(CsvTable::parse(text, "g.csv"), "07-camera", {kLines[0]}).text,
                HasSubstr("\"A, 1\",17.50,"));
    text.replace(text.find("\"20,00\""), 7, "twenty");
    EXPECT_THROW(fillCanvas(CsvTable::parse(text, "g.csv"), "07-camera", kLines), Error);
}

TEST(FillCanvas, ARowThatTwoFitIsLeftAsItIs) {
    const std::vector<Line> two = {{"222", "X", "", 10, 100, ""}, {"u2", "Y", "", 90, 100, ""}};
    const Filled filled = fillCanvas(CsvTable::parse(kCanvas, "g.csv"), "07-camera", two);
    EXPECT_EQ(filled.text, kCanvas);
    EXPECT_EQ(filled.marks, 0u);
    EXPECT_THAT(filled.remarks,
                ElementsAre(HasSubstr("X (222) fits row"), HasSubstr("Y (u2) fits")));
}

TEST(FillCanvas, AStudentWhoFitsSeveralRowsIsNotSaidToBeMissing) {
    const std::vector<Line> one = {{"12345", "X", "jo@x.edu", 10, 100, ""}};
    const Filled filled = fillCanvas(CsvTable::parse(kCanvas, "g.csv"), "07-camera", one);
    EXPECT_EQ(filled.text, kCanvas);
    EXPECT_THAT(filled.remarks,
                ElementsAre("X (12345) fits several rows, 3 and 4: they are left as they are"));
}

TEST(FillCanvas, AColumnThatIsNotClearIsRefused) {
    try {
        fillCanvas(CsvTable::parse(kCanvas, "g.csv"), "e", kLines);
        FAIL() << "several columns have an e in their name";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("name one with --column: Student, ID"));
    }
    EXPECT_THROW(fillCanvas(CsvTable::parse("a,b\n", "g.csv"), "b", kLines), Error);
}

const std::string kMoodle =
    "\xEF\xBB\xBFIdentifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Grade "
    "can "
    "be changed\",\"Feedback comments\"\n"
    "\"Participant 12345\",\"Jane Doe\",jane@x.edu,Submitted,,100.00,Yes,\n"
    "\"Participant 7\",\"Jo Roe\",jo@x.edu,Submitted,,100.00,No,\n"
    "\"Participant 8\",Zed,zed@x.edu,\"No submission\",,100.00,Yes,\n";

TEST(FillMoodle, FillsGradeAndFeedbackByParticipantEmailOrName) {
    const Filled filled = fillMoodle(CsvTable::parse(kMoodle, "w.csv"), kLines);
    EXPECT_THAT(filled.text, HasSubstr("Submitted,87.50,100.00,Yes,ok\n"));
    EXPECT_THAT(filled.text, HasSubstr("jo@x.edu,Submitted,,100.00,No,\n"));
    EXPECT_THAT(filled.text, HasSubstr("\"No submission\",1.00,100.00,Yes,\n"));
    EXPECT_TRUE(filled.text.starts_with("\xEF\xBB\xBFIdentifier,\"Full name\""));
    EXPECT_THAT(filled.remarks,
                ElementsAre(HasSubstr("someone: Moodle says that the grade cannot be changed")));
}

TEST(FillMoodle, ANameThatTwoHaveIsNobodys) {
    const std::string text = "Identifier,Full name,Grade\nParticipant 1,Zed,\nParticipant 2,Zed,\n";
    const Filled filled = fillMoodle(CsvTable::parse(text, "w.csv"), {kLines[2]});
    EXPECT_EQ(filled.text, text);
    EXPECT_THAT(filled.remarks,
                ElementsAre("Zed (999) fits several rows, 2 and 3: they are left as they are"));
}

}  // namespace
