// Who is who in a class, what being late costs, and what people decide.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "batch/Csv.h"
#include "batch/Marks.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_help::Tree;

/// The text of the Error that `action` throws; empty when it throws none.
template <class Action>
std::string complaintOf(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

Manifest someManifest() {
    Manifest manifest;
    manifest.id = "07-camera";
    manifest.submit = {"Camera.cpp", "Camera.h"};
    manifest.tasks = {{"view-matrix", "View", "", 40, {}}, {"rotate-up", "Up", "", 60, {}}};
    return manifest;
}

Intake takenIn(const Tree& tree) {
    return takeIn(tree.path(), someManifest(), {"06-rotation", "07-camera"});
}

const Entrant& called(const Intake& intake, const std::string& name) {
    for (const Entrant& each : intake.entrants)
        if (each.name == name)
            return each;
    throw Error("no entrant {}", name);
}

// Tables

TEST(CsvTable, ReadsQuotesLinesAndOtherSeparators) {
    const CsvTable table =
        CsvTable::parse("\xEF\xBB\xBFid;Name\r\n1;\"Doe; \"\"Jo\"\"\r\nhe\"\r\n 2 ;x", "f.csv");
    ASSERT_EQ(table.rows(), 2u);
    EXPECT_EQ(table.cell(0, "name"), "Doe; \"Jo\"\r\nhe");
    EXPECT_EQ(table.cell(1, "ID"), "2");
    EXPECT_EQ(table.cell(1, "missing"), "");
    EXPECT_EQ(table.place(1), "f.csv, line 4");
}

TEST(CsvTable, KeepsEveryByteThatIsNotSet) {
    const std::string text = "\xEF\xBB\xBF\"Student\" ,ID,Mark\r\n  \"a, b\",1, 3.5 \r\nlast,2";
    CsvTable table = CsvTable::parse(text, "f.csv");
    EXPECT_EQ(table.text(), text);
    table.set(1, *table.column("Mark"), "=7,5");
    EXPECT_EQ(table.text(),
              "\xEF\xBB\xBF\"Student\" ,ID,Mark\r\n  \"a, b\",1, 3.5 \r\nlast,2,\"'=7,5\"");
}

TEST(CsvTable, BadOnesAreNamedWithTheirLine) {
    EXPECT_EQ(complaintOf([] { CsvTable::parse("id\n\"a\n", "f.csv"); }),
              "f.csv, line 2: a quote is opened and never closed");
    EXPECT_THAT(complaintOf([] { CsvTable::parse("", "f.csv"); }), HasSubstr("f.csv is empty"));
    EXPECT_EQ(complaintOf([] { CsvTable::parse("id,name\n", "f.csv").needColumn("mail"); }),
              "f.csv: there is no column \"mail\"; the columns are id, name");
}

TEST(CsvTable, ACellThatIsSetSteersNothing) {
    EXPECT_EQ(csvCell("a\x1b[31mb\tc\xff\nd"), "a [31mb c? d");
    EXPECT_EQ(csvCell("\t=1"), "' =1");
    EXPECT_EQ(csvCell("\x01@1"), "' @1");
}

// Times

TEST(Moment, IsTheSameHoweverItIsWritten) {
    const Moment moment = parseMoment("2026-11-03T23:59:00+01:00", "f");
    EXPECT_EQ(toString(moment), "2026-11-03T22:59:00Z");
    EXPECT_EQ(parseMoment("2026-11-03 22:59:00.123456 UTC", "f"), moment);
    EXPECT_EQ(parseMoment("2026-11-03 17:29 -05:30", "f"), moment);
    EXPECT_EQ(toString(parseMoment("2028-02-29T00:30+02:00", "f")), "2028-02-28T22:30:00Z");
}

TEST(Moment, WithoutAZoneOrADayIsRefused) {
    EXPECT_THAT(complaintOf([] { parseMoment("2026-11-03T23:59:00", "p.json: due"); }),
                HasSubstr("p.json: due: \"2026-11-03T23:59:00\" is no time"));
    EXPECT_THAT(complaintOf([] { parseMoment("2026-02-30T00:00Z", "f"); }),
                HasSubstr("there is no such time"));
    for (const char* far : {"+15:00", "-14:60", "+99:99"})
        EXPECT_THAT(complaintOf([&] { parseMoment(std::string("2026-11-03T23:59") + far, "f"); }),
                    HasSubstr("there is no such time"));
    EXPECT_EQ(toString(parseMoment("2026-11-03T14:30+14:00", "f")), "2026-11-03T00:30:00Z");
    EXPECT_THAT(complaintOf([] { parseMoment("soon", "f"); }), HasSubstr("no time"));
}

// Exports of platforms

TEST(Export, OfCanvas) {
    const Tree tree;
    tree.write("doejane_12345_678_Camera.cpp", "old");
    tree.write("doejane_12345_700_Camera-1.cpp", "new");
    tree.write("doejane_12345_701_notes.txt", "");
    tree.write("roejo_LATE_222_900_work.zip", "");
    tree.write("readme.txt", "");
    const Intake intake = takenIn(tree);
    ASSERT_EQ(intake.entrants.size(), 2u);
    const Entrant& doe = called(intake, "doejane_12345");
    EXPECT_EQ(doe.kind, EntrantKind::looseFiles);
    ASSERT_EQ(doe.files.size(), 2u);
    EXPECT_EQ(doe.files[0].name, "Camera.cpp");
    EXPECT_EQ(readFile(doe.files[0].path), "new") << "the newest of a name";
    EXPECT_EQ(doe.owners.at(0).id, "12345");
    EXPECT_FALSE(doe.late);
    const Entrant& roe = called(intake, "roejo_222");
    EXPECT_EQ(roe.kind, EntrantKind::archive);
    EXPECT_TRUE(roe.late);
    EXPECT_THAT(intake.ignored, ElementsAre(HasSubstr("readme.txt: not named as Canvas")));
}

TEST(Export, OfMoodle) {
    const Tree tree;
    tree.write("Jane Doe_1234567_assignsubmission_file_/Camera.cpp", "");
    tree.write("Jo Roe_222_assignsubmission_file_/work.zip", "");
    tree.write("Jo Roe_222_assignsubmission_onlinetext_/onlinetext.html", "");
    tree.write("Ann Li_333_assignsubmission_file_Camera.cpp", "");
    tree.write("Eve_444_assignsubmission_file_x_222_assignsubmission_file_Camera.cpp", "");
    const Intake intake = takenIn(tree);
    ASSERT_EQ(intake.entrants.size(), 4u);
    EXPECT_EQ(called(intake, "Eve_444").owners.at(0).id, "444") << "a file's name is no owner";
    EXPECT_EQ(called(intake, "Jane Doe_1234567").owners.at(0).name, "Jane Doe");
    EXPECT_EQ(called(intake, "Jo Roe_222").kind, EntrantKind::archive);
    EXPECT_EQ(called(intake, "Ann Li_333").files.at(0).name, "Camera.cpp");
    EXPECT_EQ(called(intake, "Ann Li_333").owners.at(0).id, "333");
}

TEST(Export, OfGradescope) {
    const Tree tree;
    tree.write("submission_1/Camera.cpp", "");
    tree.write("submission_2/Camera.cpp", "");
    tree.write("submission_metadata.yml",
               "submission_1:\n  :submitters:\n  - :name: Jane Doe\n    :sid: '7'\n    :email: "
               "j@x.edu\n  - :name: Jo Roe\n    :sid: '8'\n    :email: r@x.edu\n  :created_at: "
               "2026-11-01 10:00:00.000000000 Z\n  :status: processed\n");
    const Intake intake = takenIn(tree);
    ASSERT_EQ(intake.entrants.size(), 1u);
    ASSERT_EQ(intake.entrants[0].owners.size(), 2u);
    EXPECT_EQ(intake.entrants[0].owners[1].email, "r@x.edu");
    EXPECT_EQ(toString(*intake.entrants[0].submitted), "2026-11-01T10:00:00Z");
    EXPECT_THAT(intake.ignored, ElementsAre(HasSubstr("submission_2: not in")));
    tree.write("submission_metadata.yml", "a: [");
    EXPECT_THAT(complaintOf([&] { takenIn(tree); }), HasSubstr("is not what Gradescope writes"));
}

TEST(Intake, KnowsRepositories) {
    const Tree tree;
    for (const char* each : {"clone/.git", "bare"}) {
        tree.write(std::string(each) + "/HEAD", "ref: refs/heads/main\n");
        fs::create_directories(tree / each / "objects");
        fs::create_directories(tree / each / "refs");
    }
    tree.write("worktree/.git", "gitdir: /somewhere\n");
    const Intake intake = takenIn(tree);
    EXPECT_EQ(called(intake, "clone").kind, EntrantKind::clone);
    EXPECT_EQ(called(intake, "bare").kind, EntrantKind::clone);
    EXPECT_EQ(called(intake, "worktree").kind, EntrantKind::folder);
}

TEST(Intake, TimesSayWhenAndWhose) {
    const Tree tree;
    tree.write("first/Camera.cpp", "");
    tree.write("second/Camera.cpp", "");
    Intake intake = takenIn(tree);
    tree.write("t.csv", "submission,submitted,student\nfirst,2026-11-01T10:00Z,ann\n");
    addTimes(intake, tree / "t.csv");
    EXPECT_EQ(toString(*intake.entrants[0].submitted), "2026-11-01T10:00:00Z");
    EXPECT_EQ(intake.entrants[0].owners.at(0).id, "ann");
    EXPECT_FALSE(intake.entrants[1].submitted);
    tree.write("t.csv", "submission,submitted\nthird,2026-11-01T10:00Z\n");
    EXPECT_THAT(complaintOf([&] { addTimes(intake, tree / "t.csv"); }),
                HasSubstr("t.csv, line 2: there is no submission \"third\""));
}

// The roster

class ClassTest : public testing::Test {
protected:
    std::vector<Student> roster(const std::string& lines) const {
        tree_.write("roster.csv", "id,name,email,group,due,extension\n" + lines);
        return readRoster(tree_ / "roster.csv");
    }
    static Entrant entrant(const std::string& name, std::vector<Owner> owners = {},
                           const std::string& time = "") {
        Entrant each{name, name};
        each.owners = std::move(owners);
        if (!time.empty())
            each.submitted = parseMoment(time, "test");
        return each;
    }
    static std::vector<std::string> attemptsOf(const ClassList& list, const std::string& id) {
        std::vector<std::string> names;
        for (const Participant& each : list.participants)
            if (each.student.id == id)
                for (const Entrant* attempt : each.attempts)
                    names.push_back(attempt->name);
        return names;
    }

    Tree tree_;
};

TEST_F(ClassTest, ARosterWithFaultsIsRefused) {
    EXPECT_THAT(complaintOf([&] { roster("ann,,,,,\nANN,,,,,\n"); }),
                HasSubstr("line 3: the id ANN is there already, in"));
    EXPECT_THAT(complaintOf([&] { roster(",x,,,,\n"); }), HasSubstr("line 2: the id is missing"));
    EXPECT_THAT(complaintOf([&] { roster("ann,,,,tomorrow,\n"); }), HasSubstr("line 2: due"));
    EXPECT_THAT(complaintOf([&] { roster("ann,,,,,2 weeks\n"); }), HasSubstr("days or hours"));
    EXPECT_THAT(complaintOf([&] { roster(""); }), HasSubstr("names no student"));
}

TEST_F(ClassTest, IdsEmailsAndUniqueNamesDecideAndNothingIsGuessed) {
    const auto students = roster(
        "1,Ann Li,ann@x.edu,,,\n2,Jo Roe,jo@x.edu,,,\n3,Jo Roe,roe@x.edu,,,\n4,Zed,z@x.edu,,,\n");
    Intake intake;
    intake.entrants = {entrant("a", {{"", "", "ANN@x.edu"}}), entrant("b", {{"", "Jo Roe", ""}}),
                       entrant("3"), entrant("stranger")};
    const ClassList list = whoIsWho(intake, &students);
    EXPECT_THAT(attemptsOf(list, "1"), ElementsAre("a"));
    EXPECT_THAT(attemptsOf(list, "2"), IsEmpty());
    EXPECT_THAT(attemptsOf(list, "3"), ElementsAre("3"));
    EXPECT_THAT(attemptsOf(list, "4"), IsEmpty()) << "missing, and listed";
    EXPECT_THAT(attemptsOf(list, "stranger"), ElementsAre("stranger"));
    EXPECT_THAT(list.unclear, ElementsAre("b could be the submission of 2 or of 3"));
    EXPECT_EQ(list.participants.size(), 5u);
    EXPECT_FALSE(list.participants.back().inRoster);
}

TEST_F(ClassTest, AGroupHandsInForAll) {
    const auto students = roster("1,A,,red,,\n2,B,,red,,\n3,C,,blue,,\n");
    Intake intake;
    intake.entrants = {entrant("red"), entrant("s", {{"3", "", ""}, {"1", "", ""}})};
    const ClassList list = whoIsWho(intake, &students);
    EXPECT_THAT(attemptsOf(list, "2"), ElementsAre("red"));
    EXPECT_THAT(attemptsOf(list, "3"), ElementsAre("s"));
    EXPECT_THAT(list.participants.at(0).problem, HasSubstr("handed in as red and as s"));
}

TEST_F(ClassTest, TheRuleChoosesAmongAttempts) {
    Policy policy;
    policy.due = parseMoment("2026-11-02T00:00Z", "test");
    Intake intake;
    intake.entrants = {entrant("late", {{"ann", "", ""}}, "2026-11-03T00:00Z"),
                       entrant("first", {{"ann", "", ""}}, "2026-11-01T00:00Z"),
                       entrant("second", {{"ann", "", ""}}, "2026-11-02T00:00Z")};
    const ClassList list = whoIsWho(intake, nullptr);
    ASSERT_EQ(list.participants.size(), 1u);
    const Participant& ann = list.participants[0];
    const auto names = [&](AttemptRule rule) {
        std::vector<std::string> all;
        for (const Entrant* each : attemptsToGrade(ann, rule, policy))
            all.push_back(each->name);
        return all;
    };
    EXPECT_THAT(names(AttemptRule::last), ElementsAre("late"));
    EXPECT_THAT(names(AttemptRule::onTime), ElementsAre("second"));
    EXPECT_THAT(names(AttemptRule::best), ElementsAre("first", "second", "late"));
}

// Deadlines

TEST_F(ClassTest, DaysThatHaveBegunAreCharged) {
    tree_.write("p.json", R"({"format": 1, "due": "2026-11-02T00:00Z",
        "late": {"free_days": 1, "percent_per_day": 20, "cap_percent": 50}})");
    const Policy policy = Policy::load(tree_ / "p.json");
    const auto latenessAt = [&](const std::string& time, const Student& student) {
        return latenessOf(student, entrant("x", {}, time), policy);
    };
    EXPECT_FALSE(latenessAt("2026-11-02T00:00:00Z", {}).late);
    EXPECT_EQ(latenessAt("2026-11-02T00:00:01Z", {}).days, 1);
    EXPECT_EQ(latenessAt("2026-11-02T00:00:01Z", {}).percent, 0) << "a free day";
    EXPECT_EQ(latenessAt("2026-11-03T00:00:01Z", {}).percent, 20);
    EXPECT_EQ(latenessAt("2026-11-09T00:00:00Z", {}).percent, 50) << "the cap";
    EXPECT_THAT(latenessAt("2026-11-03T12:00:00Z", {}).says, HasSubstr("2 days late (due"));
    const auto extended =
        roster("ann,,,,,2d\njo,,,,2026-11-01T00:00Z,\nli,,,,,2026-12-01T00:00Z\n");
    EXPECT_FALSE(latenessAt("2026-11-03T12:00:00Z", extended[0]).late);
    EXPECT_EQ(latenessAt("2026-11-01T12:00:00Z", extended[1]).days, 1);
    EXPECT_FALSE(latenessAt("2026-11-30T12:00:00Z", extended[2]).late);
    tree_.write("p.json", R"({"format": 1, "due": "2026-11-02T00:00Z",
        "late": {"free_days": 0.5, "percent_per_day": 20}})");
    const Policy grace = Policy::load(tree_ / "p.json");
    const auto percentAt = [&](const std::string& time) {
        return latenessOf({}, entrant("x", {}, time), grace).percent;
    };
    EXPECT_EQ(percentAt("2026-11-02T12:00:00Z"), 0) << "half a day's grace";
    EXPECT_EQ(percentAt("2026-11-02T12:00:01Z"), 20);
    Entrant canvas = entrant("x");
    canvas.late = true;
    const Lateness unknown = latenessOf({}, canvas, policy);
    EXPECT_TRUE(unknown.late);
    EXPECT_EQ(unknown.percent, 0) << "nothing is guessed";
}

TEST_F(ClassTest, APolicyWithFaultsIsRefused) {
    tree_.write("p.json", R"({"format": 1, "late": {"percent_per_day": -1}})");
    EXPECT_THAT(complaintOf([&] { Policy::load(tree_ / "p.json"); }),
                HasSubstr("percent_per_day must not be negative"));
    tree_.write("p.json", R"({"format": 1, "grace": 3})");
    EXPECT_THAT(complaintOf([&] { Policy::load(tree_ / "p.json"); }),
                HasSubstr("unknown field \"grace\""));
}

// Marks

class MarksTest : public ClassTest {
protected:
    MarksTest() { intake_.entrants = {entrant("ann", {}, "2026-11-03T12:00Z"), entrant("bob")}; }

    static Standing graded(const std::string& name, double view, double up) {
        return {
            name,
            "graded",
            "",
            view + up,
            100,
            std::make_shared<Essence>(Essence{{{"view-matrix", view, ""}, {"rotate-up", up, ""}}, {}}),
            "",
            false};
    }
    std::vector<Mark> marks(const std::string& decisions = "", double view = 20) {
        Overrides overrides;
        if (!decisions.empty()) {
            tree_.write("o.csv", "student,task,points,reason\n" + decisions);
            overrides = Overrides(tree_ / "o.csv", tree_ / "memory.json", someManifest());
        }
        Policy policy;
        policy.due = parseMoment("2026-11-02T00:00Z", "test");
        policy.percentPerDay = 10;
        const auto students = roster("ann,,,,,\nbob,,,,,\ncy,,,,,\n");
        const ClassList list = whoIsWho(intake_, &students);
        auto all =
            marksOf(someManifest(), list,
                    {{"ann", graded("ann", view, 60)},
                     {"bob", {"bob", fault_, "it is encrypted", 0, 0, nullptr, "", false}},
                     {"ann2", {"ann2", "grader_error", "no disk", 0, 0, nullptr, "", false}}},
                    rule_, policy, overrides);
        overrides.remember();
        return all;
    }

    Intake intake_;
    std::string fault_ = "refused";  ///< what became of bob
    AttemptRule rule_ = AttemptRule::last;
};

TEST_F(MarksTest, TheBestOfAttemptsIsNotKnownWhereTheGraderFailedAtOne) {
    intake_.entrants.push_back(entrant("ann2", {{"ann", "", ""}}, "2026-11-01T00:00:00Z"));
    rule_ = AttemptRule::best;
    const auto all = marks();
    EXPECT_EQ(all[0].status, "grader_error");
    EXPECT_EQ(all[0].sentence, "no disk");
}

TEST_F(MarksTest, LatenessIsTakenFromWhatWasEarned) {
    const auto all = marks();
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].automatic, 80);
    EXPECT_EQ(all[0].points, 64) << "two days at 10 %";
    EXPECT_EQ(all[1].status, "refused");
    EXPECT_EQ(all[1].sentence, "it is encrypted");
    EXPECT_EQ(all[2].status, "missing");
    EXPECT_EQ(all[2].maxPoints, 100);
}

TEST_F(MarksTest, DecisionsStayAndWarnWhenTheMarkUnderThemChanged) {
    const std::string decisions = "ann,view-matrix,40,it was our fault\nbob,rotate-up,5,on paper\n";
    const auto before = marks(decisions);
    EXPECT_EQ(before[0].points, 80) << "100 less 20 %";
    EXPECT_EQ(before[0].automatic, 80);
    EXPECT_THAT(before[0].warnings, IsEmpty());
    EXPECT_EQ(before[1].status, "decided");
    EXPECT_EQ(before[1].points, 5);
    EXPECT_THAT(before[0].remarks(),
                ElementsAre(HasSubstr("view-matrix: 40 of 40 points by a person's decision"),
                            HasSubstr("2 days late")));
    const auto after = marks(decisions, 30);
    EXPECT_EQ(after[0].points, 80);
    EXPECT_THAT(after[0].warnings,
                ElementsAre(HasSubstr("the automatic mark was 20 when it was decided, and is 30")));
    EXPECT_THAT(marks(decisions, 30)[0].warnings, testing::SizeIs(1)) << "until somebody looks";
    EXPECT_THAT(marks("ann,view-matrix,40,looked again\n", 30)[0].warnings, IsEmpty());
}

TEST_F(MarksTest, AFaultOfTheGraderIsNoMarkUntilEverythingIsDecided) {
    fault_ = "grader_error";
    const auto partly = marks("bob,rotate-up,5,on paper\n");
    EXPECT_EQ(partly[1].status, "grader_error");
    EXPECT_FALSE(partly[1].sentence.empty());
    const auto wholly = marks("bob,rotate-up,5,on paper\nbob,view-matrix,6,on paper\n");
    EXPECT_EQ(wholly[1].status, "decided");
    EXPECT_EQ(wholly[1].points, 11);
}

TEST_F(MarksTest, WhatIsNotGradedThisTimeIsRememberedAllTheSame) {
    const std::string decisions = "ann,view-matrix,40,it was our fault\n";
    marks(decisions);
    tree_.write("o.csv", "student,task,points,reason\n" + decisions);
    Overrides stopped(tree_ / "o.csv", tree_ / "memory.json", someManifest());
    stopped.remember();  // before anything was graded
    EXPECT_THAT(marks(decisions, 30)[0].warnings, testing::SizeIs(1));
}

TEST_F(MarksTest, ADamagedMemoryOfDecisionsIsNamed) {
    tree_.write("memory.json", "[1]");
    EXPECT_THAT(complaintOf([&] { marks("ann,view-matrix,1,x\n"); }),
                testing::AllOf(HasSubstr("memory.json is not as"), HasSubstr("move it away")));
}

TEST_F(MarksTest, DecisionsWithFaultsAreRefused) {
    EXPECT_THAT(complaintOf([&] { marks("ann,view,1,x\n"); }),
                HasSubstr("line 2: 07-camera has no task \"view\"; it has view-matrix, rotate-up"));
    EXPECT_THAT(complaintOf([&] { marks("ann,view-matrix,41,x\n"); }),
                HasSubstr("expected a number from 0 to 40"));
    EXPECT_THAT(complaintOf([&] { marks("ann,view-matrix,1,\n"); }), HasSubstr("a reason"));
    EXPECT_THAT(complaintOf([&] { marks("ann,view-matrix,1,x\nann,view-matrix,2,y\n"); }),
                HasSubstr("has a decision on view-matrix already"));
}

}  // namespace
