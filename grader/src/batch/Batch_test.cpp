#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "Error.h"
#include "batch/Intake.h"
#include "batch/Keys.h"
#include "batch/Ledger.h"
#include "batch/Overview.h"
#include "batch/Progress.h"
#include "testing/AsNobody.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing_help::AsNobody;
using testing_help::Tree;
using testing_help::whatOf;

Manifest someManifest() {
    Manifest manifest;
    manifest.id = "06-rotation";
    manifest.title = "Rotation";
    manifest.submit = {"rotation.cpp"};
    manifest.tasks = {{"cross-matrix", "Cross", "", 40, {}}, {"rotation", "Turn", "", 60, {}}};
    return manifest;
}

Intake takenIn(const Tree& tree) {
    return takeIn(tree.path(), someManifest(), {"06-rotation", "07-camera"});
}

TEST(Intake, TakesFoldersAndArchivesAndNamesTheRest) {
    const Tree tree;
    tree.write("beta/06-rotation/rotation.cpp", "");
    tree.write("alpha.tar.gz", "");
    tree.write("gamma/work.zip", "");
    tree.write("delta/rotation.cpp", "");
    tree.write("delta/old.zip", "");
    tree.write("list.txt", "");
    tree.write(".hidden/x", "");
    fs::create_symlink("/etc", tree / "epsilon");
    const Intake intake = takenIn(tree);
    std::vector<std::string> found;
    for (const Entrant& each : intake.entrants)
        found.push_back(each.name + (each.kind == EntrantKind::archive ? " archive " : " folder ") +
                        each.path.filename().string());
    EXPECT_THAT(found, ElementsAre("alpha archive alpha.tar.gz", "beta folder beta",
                                   "delta folder delta", "gamma archive work.zip"));
    EXPECT_THAT(intake.ignored, ElementsAre("epsilon: neither a folder nor an archive",
                                            "list.txt: neither a folder nor an archive"));
}

TEST(Intake, TakesSingleFilesWhereOneIsWanted) {
    const Tree tree;
    tree.write("ann.cpp", "x");
    tree.write("notes.txt", "");
    const Intake intake = takenIn(tree);
    ASSERT_EQ(intake.entrants.size(), 1u);
    EXPECT_EQ(intake.entrants[0].name, "ann");
    EXPECT_EQ(intake.entrants[0].files.at(0).name, "rotation.cpp");
    EXPECT_THAT(intake.ignored, ElementsAre("notes.txt: neither a folder nor an archive"));
    Manifest two = someManifest();
    two.submit.push_back("more.cpp");
    EXPECT_THROW(takeIn(tree.path(), two, {}), Error) << "which of the two it is nobody knows";
}

TEST(Intake, RefusesWhatItWouldHaveToGuess) {
    const Tree tree;
    EXPECT_THROW(takenIn(tree), Error) << "nothing in it";
    tree.write("alpha/rotation.cpp", "");
    tree.write("alpha.zip", "");
    try {
        takenIn(tree);
        FAIL() << "one name for two submissions";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("alpha is there twice"));
    }
    EXPECT_THROW(takeIn(tree / "missing", someManifest(), {}), Error);
}

TEST(Intake, WhatIsThereTwiceIsNamedByItsPlace) {
    const Tree loose, clone;
    loose.write("ann/rotation.cpp", "");
    loose.write("ann.cpp", "");
    EXPECT_THAT(whatOf<Error>([&] { takenIn(loose); }), HasSubstr("ann.cpp"));
    clone.write("bob.zip", "");
    clone.write("bob/.git/HEAD", "");
    for (const char* each : {"objects", "refs"})
        fs::create_directories(clone / "bob/.git" / each);
    EXPECT_THAT(whatOf<Error>([&] { takenIn(clone); }), HasSubstr("bob/.git"));
}

class LayingOut : public testing::Test {
protected:
    LayingOut() {
        for (const char* each : {"work.zip", "ann.cpp", "clone/.git/HEAD",
                                 "clone/.git/objects/33/4", "clone/.git/refs/heads/master"})
            tree_.write(each, "x");
    }
    Unpacked laidOut(const Entrant& entrant, const Job& job) const {
        return layOut(Toolchain(), *makePlainProcess(""), job, entrant, {});
    }

    const Tree tree_;
    const Entrant archive_{"work", tree_ / "work.zip", EntrantKind::archive};
    const Entrant clone_{"clone", tree_ / "clone/.git", EntrantKind::clone};
    const Entrant loose_{
        "ann", tree_.path(), EntrantKind::looseFiles, {{"rotation.cpp", tree_ / "ann.cpp"}}};
};

TEST_F(LayingOut, RefusesWhatMayNotBeRead) {
    for (const auto& [entrant, closed] :
         {std::pair(archive_, "work.zip"), std::pair(loose_, "ann.cpp"),
          std::pair(clone_, "clone/.git/HEAD"), std::pair(clone_, "clone/.git/objects/33"),
          std::pair(clone_, "clone/.git/refs/heads/master")}) {
        const auto before = fs::status(tree_ / closed).permissions();
        fs::permissions(tree_ / closed, fs::perms::none);
        {
            const AsNobody other;
            if (!other.worked())
                GTEST_SKIP() << "root cannot become another user here, and reads everything";
            const Job job;
            EXPECT_EQ(laidOut(entrant, job).refusal, kUnreadable) << closed;
            EXPECT_NO_THROW(keyOf({}, tree_.path(), someManifest(), entrant, {})) << closed;
        }
        fs::permissions(tree_ / closed, before);
    }
}

TEST_F(LayingOut, ShowsLooseFilesToNobodyElse) {
    const Job job;
    const fs::path folder = laidOut(loose_, job).folder;
    EXPECT_EQ(readFile(folder / "rotation.cpp"), "x");
    EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all);
}

TEST(Ledger, KnowsOnlyWhatIsWholeAndHasTheSameKey) {
    const Tree tree;
    const Ledger ledger(tree.path());
    const Key key{"key", "words"};
    EXPECT_FALSE(ledger.known("alpha", key));
    ledger.begin("alpha");
    ledger.keep("alpha", key, "{\"points\": 3}");
    ASSERT_TRUE(ledger.known("alpha", key));
    EXPECT_EQ(ledger.known("alpha", key)->result.at("points"), 3);
    EXPECT_FALSE(ledger.known("alpha", {"another", "words"}));
    ASSERT_TRUE(ledger.known("alpha", {"key", "others"})) << "it can be marked again";
    EXPECT_EQ(ledger.known("alpha", {"key", "others"})->wording, "words");
    writeFile(ledger.folderOf("alpha") / "result.json", "{\"points\": ");
    EXPECT_FALSE(ledger.known("alpha", key)) << "a file that is cut off";
    ledger.begin("beta");
    ledger.keep("beta", std::nullopt, "{}");
    EXPECT_FALSE(ledger.known("beta", key)) << "a grader's fault is not remembered";
    ledger.keep("gamma", key, "{}");
    ledger.begin("gamma");
    EXPECT_FALSE(ledger.known("gamma", key)) << "what is begun anew is not known";
}

TEST(Progress, SaysNamesOnOneLineAndHarmless) {
    testing::internal::CaptureStderr();
    Progress(2, false).count("a\x1b[31m\n::error::b 3 of 4", false, false);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "1/2 a [31m ::error::b 3 of 4\n");
}

TEST(Progress, ForeseesTheEnd) {
    EXPECT_EQ(paceOf(0, 5, 10), "");
    EXPECT_EQ(paceOf(10, 5, 20), "2.0/s, 10 s left");
    EXPECT_EQ(paceOf(10, 20, 500), "0.5/s, 17 min left");
}

class OverviewTest : public testing::Test {
protected:
    OverviewTest() {
        marks_.resize(3);
        Mark& alpha = marks_[0];
        alpha.student = {"=alpha", "\"the\" <b>first</b>", "", "B"};
        alpha.submission = "a, <i>";
        alpha.status = "graded";
        alpha.tasks = {{"cross-matrix", 40, 40, 40, false, ""},
                       {"rotation", 30, 20, 60, false, "copied"}};
        alpha.automatic = 70;
        alpha.points = 54;
        alpha.maxPoints = 100;
        alpha.lateness = {true, 2, 10, "2 days late"};
        alpha.warnings = {"rotation: look again"};
        alpha.result = std::make_shared<Essence>(Essence{
            {{"rotation", 20, "You turn clockwise."}},
            {{"turned", "Turned <cube>", "fail", 0, 5, "", "06-rotation/turned.submission.png"}}});
        marks_[1].student.id = "beta";
        marks_[1].status = "refused";
        marks_[1].sentence = "the archive is refused: it is encrypted";
        marks_[2].student.id = "gamma";
        marks_[2].status = "grader_error";
        marks_[2].sentence = "no memory";
        for (Mark* each : {&marks_[1], &marks_[2]})
            each->tasks = {{"cross-matrix", 0, 0, 40, false, ""},
                           {"rotation", 0, 0, 60, false, ""}};
        manifest_.frames.resize(1);
        manifest_.frames[0].id = "turned";
        for (const char* whose : {"students", "instructor"})
            tree_.write(std::string(whose) + "/a, <i>/report/index.html", "");
        tree_.write("instructor/a, <i>/report/06-rotation/turned.reference.png", "");
    }
    Overview overview() const {
        return {manifest_, marks_, notTaken_, alike_, class_, 7, Json{{"sandbox", "bubblewrap"}}};
    }

    Tree tree_;
    Manifest manifest_ = someManifest();
    std::vector<Mark> marks_;
    std::vector<std::string> notTaken_ = {"list.txt: neither a folder nor an archive"};
    std::vector<std::string> class_ = {"=alpha", "beta", "gamma", "delta"};
    std::vector<Likeness> alike_ = {{"a, <i>", "beta", 0.93, false}};
};

TEST_F(OverviewTest, TheTableQuotesAndHasAColumnForEachTask) {
    EXPECT_EQ(
        overview().csv(),
        "student,name,section,submission,status,points,max_points,days_late,cross-matrix,"
        "rotation,sentence,remarks\r\n"
        "'=alpha,\"\"\"the\"\" <b>first</b>\",B,\"a, <i>\",graded,54.00,100.00,2,40.00,20.00,,"
        "\"rotation: 20 of 60 points by a person's decision, in place of 30: copied | 2 days "
        "late\"\r\n"
        "beta,,,,refused,0.00,0.00,0,0.00,0.00,the archive is refused: it is encrypted,\r\n"
        "gamma,,,,grader_error,0.00,0.00,0,0.00,0.00,no memory,\r\n");
}

TEST_F(OverviewTest, ThePageEscapesLinksAndPutsFaultsOnTop) {
    const std::string page = overviewPage(overview(), tree_.path());
    EXPECT_THAT(page, Not(HasSubstr("<b>first</b>")));
    EXPECT_THAT(page, Not(HasSubstr("<cube>")));
    EXPECT_THAT(page, HasSubstr("instructor/a%2C%20%3Ci%3E/report/index.html"))
        << "the instructor's own report, where there is one";
    EXPECT_THAT(page, HasSubstr("<b>gamma</b>: a fault of the grader, no mark: no memory"));
    EXPECT_LT(page.find("a fault of the grader"), page.find("<b>beta</b>: no mark"));
    EXPECT_LT(page.find("<b>beta</b>: no mark"), page.find("look again"));
    EXPECT_LT(page.find("look again"), page.find("<table"));
    EXPECT_THAT(page, HasSubstr("1 with a mark (mean 54.0 points)"));
    EXPECT_THAT(page, HasSubstr("list.txt: neither"));
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST_F(OverviewTest, ThePageCountsMistakesAndShowsPicturesBesideTheReference) {
    const std::string page = overviewPage(overview(), tree_.path());
    EXPECT_THAT(page, HasSubstr("1 of 1</td>"));
    EXPECT_THAT(page, HasSubstr("rotation: You turn clockwise."));
    EXPECT_THAT(page, HasSubstr("turned: Turned &lt;cube&gt;"));
    EXPECT_THAT(page, HasSubstr("students/a%2C%20%3Ci%3E/report/06-rotation/turned.submission"));
    EXPECT_THAT(page, HasSubstr("instructor/a%2C%20%3Ci%3E/report/06-rotation/turned.reference"));
    EXPECT_THAT(page, HasSubstr("93 % of the fingerprints"));
}

TEST_F(OverviewTest, TheDocumentHasEveryStudent) {
    const Json document = Json::parse(overview().json());
    ASSERT_EQ(document.at("students").size(), 3u);
    const Json& alpha = document.at("students").at(0);
    EXPECT_EQ(alpha.at("tasks").at(1).at("points"), 20);
    EXPECT_EQ(alpha.at("tasks").at(1).at("automatic"), 30);
    EXPECT_EQ(alpha.at("late").at("percent"), 10);
    EXPECT_EQ(document.at("students").at(1).at("status"), "refused");
    EXPECT_EQ(document.at("seed"), 7);
}

}  // namespace
