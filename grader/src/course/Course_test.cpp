// A course of one assignment, made for each test, with one thing wrong in it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "Mistakes.h"
#include "course/CheckTexts.h"
#include "course/MistakeTable.h"
#include "course/SyncedStarter.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing_help::Tree;
using testing_help::whatOf;

const std::string kBegin = "// BEGIN TODO(turn)\n", kEnd = "// END TODO(turn)\n";

std::string file(const std::string& body, const std::string& before = "int before;\n") {
    return before + kBegin + body + kEnd;
}

class SmallCourse : public testing::Test {
protected:
    SmallCourse() {
        tools_.root = tree_.path();
        tree_.write("assignments/01-tiny/assignment.json", R"json({
            "format": 1, "id": "01-tiny", "title": "Tiny", "chapter": 1, "summary": "Small.",
            "submit": ["turn.cpp"], "inherits": {},
            "limits": {"build_seconds": 30, "call_seconds": 1, "memory_mib": 512},
            "tasks": [{"id": "turn", "title": "Turn", "points": 100, "needs": [], "hint": "Turn."}],
            "frames": [], "starter_passes": []})json");
        tree_.write("assignments/01-tiny/README.md", "# Tiny\n\n## `turn` Turn (100 points)\n");
        tree_.write("assignments/01-tiny/turn.cpp", file("int blank;\n"));
        tree_.write("solutions/01-tiny/turn.cpp", file("int solved;\n"));
        tree_.write("solutions/01-tiny/mistakes.json", R"json([
            {"id": "wrong", "region": "turn", "file": "turn.cpp", "loses": ["turn"],
             "says": "It is wrong.", "section": "1"}])json");
        tree_.write("solutions/01-tiny/mistakes/wrong.cpp", "int wrong;\n");
    }

    /// What the text checks print.
    std::string found() const {
        Findings findings;
        testing::internal::CaptureStdout();
        checkTexts(tools_, loadAssignment(tools_.root, "01-tiny"), findings);
        checkIds(tools_, findings);
        const std::string text = testing::internal::GetCapturedStdout();
        EXPECT_EQ(findings.count() > 0, !text.empty());
        return text;
    }

    Tree tree_;
    Toolchain tools_;
};

TEST_F(SmallCourse, IsConsistent) {
    EXPECT_EQ(found(), "");
}

TEST_F(SmallCourse, TextOutsideTheRegionsMustBeTheSame) {
    tree_.write("solutions/01-tiny/turn.cpp", file("int solved;\n", "int after;\n"));
    EXPECT_THAT(found(), HasSubstr("starter and solution differ outside the TODO regions"));
    EXPECT_THAT(found(), HasSubstr("./grade sync-starters 01-tiny"));
}

TEST_F(SmallCourse, TheHandoutHasAHeadingWithThePoints) {
    tree_.write("assignments/01-tiny/README.md", "# Tiny\n\n## `turn` Turn (90 points)\n");
    EXPECT_THAT(found(), HasSubstr("expected one heading ## `turn` … (100 points), found 0"));
}

TEST_F(SmallCourse, AFileThatNobodyExpectsIsNamed) {
    const fs::path stray = tree_.write("solutions/01-tiny/notes.txt", "?");
    EXPECT_THAT(found(), HasSubstr("rm " + stray.string()));
}

TEST_F(SmallCourse, AnOrphanReferenceIsNamed) {
    const fs::path orphan = tree_.write("reference_images/01-tiny/gone.png", "?");
    EXPECT_THAT(found(), HasSubstr(orphan.string() + " belongs to no frame"));
}

TEST_F(SmallCourse, ARegionBelongsToATask) {
    for (const char* tree : {"assignments", "solutions"})
        tree_.write(std::string(tree) + "/01-tiny/turn.cpp",
                    file("\n") + "// BEGIN TODO(jump)\n// END TODO(jump)\n");
    EXPECT_THAT(found(), HasSubstr("a region TODO(jump) that is no task"));
}

TEST_F(SmallCourse, ATaskHasARegion) {
    for (const char* tree : {"assignments", "solutions"})
        tree_.write(std::string(tree) + "/01-tiny/turn.cpp", "int nothing;\n");
    EXPECT_THAT(found(), HasSubstr("has 0 regions TODO(turn), expected 1"));
}

TEST_F(SmallCourse, MistakesAreAnArray) {
    const fs::path file = tree_.write("solutions/01-tiny/mistakes.json", "{}");
    EXPECT_EQ(whatOf<Error>([&] { readMistakes(file.parent_path()); }),
              file.string() + ": expected an array of mistakes, found object");
}

TEST(SyncedStarter, CarriesTextOutsideTheRegionsAndKeepsTheBlanks) {
    EXPECT_EQ(syncedStarter("turn.cpp", file("int blank;\n", "int old;\n"),
                            file("int solved;\n", "int fresh;\n")),
              file("int blank;\n", "int fresh;\n"));
}

TEST(SyncedStarter, RefusesWhatItWouldHaveToGuess) {
    EXPECT_THAT(
        whatOf<Error>([] { syncedStarter("turn.cpp", "int old;\n", file("")); }),
        HasSubstr("turn.cpp: the solution has a region TODO(turn) and the starter has none"));
    EXPECT_THAT(whatOf<Error>([] { syncedStarter("turn.cpp", file(""), "int fresh;\n"); }),
                HasSubstr("the starter has a region TODO(turn) and the solution has none"));
}

TEST(MistakeTable, KnowsTheChecksThatNothingFails) {
    CheckResult lost, kept, worthless;
    lost.id = "Turn.Once";
    lost.status = Status::fail;
    kept.id = "Turn.Twice";
    kept.status = worthless.status = Status::pass;
    worthless.id = "picture";
    lost.points = 0;
    lost.maxPoints = kept.points = kept.maxPoints = 1;
    MistakeTable table;
    table.add({}, {lost, kept, worthless});
    EXPECT_THAT(table.neverFailed(), ElementsAre("Turn.Twice"));
}

}  // namespace
