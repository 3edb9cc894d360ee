#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "batch/Intake.h"
#include "batch/Ledger.h"
#include "batch/Overview.h"
#include "batch/Progress.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing_help::Tree;

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
        found.push_back(each.name + (each.isArchive ? " archive " : " folder ") +
                        each.path.filename().string());
    EXPECT_THAT(found, ElementsAre("alpha archive alpha.tar.gz", "beta folder beta",
                                   "delta folder delta", "gamma archive work.zip"));
    EXPECT_THAT(intake.ignored, ElementsAre("epsilon: neither a folder nor an archive",
                                            "list.txt: neither a folder nor an archive"));
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

TEST(Ledger, KnowsOnlyWhatIsWholeAndHasTheSameKey) {
    const Tree tree;
    const Ledger ledger(tree.path());
    EXPECT_FALSE(ledger.known("alpha", "key"));
    ledger.begin("alpha");
    ledger.keep("alpha", "key", "{\"points\": 3}");
    ASSERT_TRUE(ledger.known("alpha", "key"));
    EXPECT_EQ(ledger.known("alpha", "key")->at("points"), 3);
    EXPECT_FALSE(ledger.known("alpha", "another"));
    writeFile(ledger.folderOf("alpha") / "result.json", "{\"points\": ");
    EXPECT_FALSE(ledger.known("alpha", "key")) << "a file that is cut off";
    ledger.begin("beta");
    ledger.keep("beta", "", "{}");
    EXPECT_FALSE(ledger.known("beta", "")) << "a grader's fault is not remembered";
    ledger.keep("gamma", "key", "{}");
    ledger.begin("gamma");
    EXPECT_FALSE(ledger.known("gamma", "key")) << "what is begun anew is not known";
}

TEST(Progress, ForeseesTheEnd) {
    EXPECT_EQ(paceOf(0, 5, 10), "");
    EXPECT_EQ(paceOf(10, 5, 20), "2.0/s, 10 s left");
    EXPECT_EQ(paceOf(10, 20, 500), "0.5/s, 17 min left");
}

class OverviewTest : public testing::Test {
protected:
    Overview overview() const { return {manifest_, standings_, ignored_, 7, "bubblewrap"}; }

    Manifest manifest_ = someManifest();
    std::vector<Standing> standings_ = {
        {"=alpha, \"the\" <b>first</b>", "graded", "", 70, 100,
         Json{{"tasks",
               {{{"id", "cross-matrix"}, {"points", 40}}, {{"id", "rotation"}, {"points", 30}}}}},
         false},
        {"beta", "refused", "the archive is refused: it is encrypted", 0, 0, Json::object(), false},
        {"gamma", "grader_error", "no memory", 0, 0, nullptr, false}};
    std::vector<std::string> ignored_ = {"list.txt: neither a folder nor an archive"};
};

TEST_F(OverviewTest, TheTableQuotesAndHasAColumnForEachTask) {
    EXPECT_EQ(overview().csv(),
              "student,status,points,max_points,cross-matrix,rotation,sentence\r\n"
              "\"'=alpha, \"\"the\"\" <b>first</b>\",graded,70.00,100.00,40.00,30.00,\r\n"
              "beta,refused,0.00,0.00,,,the archive is refused: it is encrypted\r\n"
              "gamma,grader_error,0.00,0.00,,,no memory\r\n");
}

TEST_F(OverviewTest, ThePageEscapesLinksAndPutsFaultsOnTop) {
    const std::string page = overview().html();
    EXPECT_THAT(page, Not(HasSubstr("<b>first</b>")));
    EXPECT_THAT(page, HasSubstr("students/%3Dalpha%2C%20%22the%22%20%3Cb%3Efirst%3C/b%3E/report"));
    EXPECT_THAT(page, HasSubstr("<b>gamma</b>: a fault of the grader, no mark: no memory"));
    EXPECT_LT(page.find("a fault of the grader"), page.find("<table>"));
    EXPECT_THAT(page, HasSubstr("mean 70.0 points")) << "only one has a mark";
    EXPECT_THAT(page, HasSubstr("not taken: list.txt"));
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

TEST_F(OverviewTest, TheDocumentHasEveryStudent) {
    const Json document = Json::parse(overview().json());
    ASSERT_EQ(document.at("students").size(), 3u);
    EXPECT_EQ(document.at("students").at(0).at("tasks").at("rotation"), 30);
    EXPECT_EQ(document.at("students").at(1).at("status"), "refused");
    EXPECT_EQ(document.at("seed"), 7);
}

}  // namespace
