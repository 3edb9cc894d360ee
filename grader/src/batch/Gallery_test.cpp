#include "batch/Gallery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::HasSubstr;
using testing::Not;
using testing_help::Tree;
using testing_help::whatOf;

/// A batch of three students with a name that must not be seen; two have the same picture.
class GalleryTest : public testing::Test {
protected:
    GalleryTest() {
        tree_.write("assignments/01-tiny/assignment.json", R"json({
            "format": 1, "id": "01-tiny", "title": "Tiny", "chapter": 1, "summary": "Small.",
            "submit": ["turn.cpp"], "inherits": {}, "limits": {},
            "tasks": [{"id": "turn", "title": "Turn", "points": 100, "needs": [], "hint": "Turn."}],
            "frames": [{"id": "up", "title": "Up & away", "size": [4, 4], "task": "turn",
                        "points": 10},
                       {"id": "never", "title": "Nobody's", "size": [4, 4], "task": "turn",
                        "points": 10}],
            "starter_passes": []})json");
        tree_.write("out/results.json", R"json({"assignment": "01-tiny", "students": [
            {"student": "lovelace", "submission": "lovelace"},
            {"student": "noether", "submission": "noether"},
            {"student": "hopper", "submission": "hopper"},
            {"student": "missing", "submission": ""}]})json");
        picture("lovelace", "submission", "alike");
        picture("noether", "submission", "different");
        picture("hopper", "submission", "alike");
        picture("hopper", "reference", "right");
        tree_.write("out/instructor/noether/report/01-tiny/never.reference.png", "secret");
        tree_.write("out/students/other/report/01-tiny/up.submission.png",
                    "not the one that counts");
    }

    void picture(const std::string& who, const std::string& kind, const std::string& bytes) const {
        tree_.write("out/students/" + who + "/report/01-tiny/up." + kind + ".png", bytes);
    }
    std::string refusal(const std::string& results, const std::string& into) const {
        return whatOf<Error>([&] { writeGallery(tree_.path(), tree_ / results, tree_ / into); });
    }

    Tree tree_;
};

TEST_F(GalleryTest, ShowsEveryPictureOnceAndNobodysName) {
    const GalleryCount count = writeGallery(tree_.path(), tree_ / "out", tree_ / "gallery");
    EXPECT_EQ(count.students, 3u);
    EXPECT_EQ(count.pictures, 2u);
    const std::string page = readFile(tree_ / "gallery/index.html");
    EXPECT_THAT(page, HasSubstr("Up &amp; away"));
    EXPECT_LT(page.find("the reference"), page.find("2 students</figcaption>"));
    EXPECT_LT(page.find("2 students</figcaption>"), page.find("one student</figcaption>"));
    EXPECT_THAT(page, Not(HasSubstr("Nobody&#39;s"))) << "a frame without a picture";

    std::string all = page;
    std::vector<std::string> contents;
    for (const auto& entry : fs::recursive_directory_iterator(tree_ / "gallery"))
        if (entry.path().extension() == ".png") {
            all += entry.path().string();
            contents.push_back(readFile(entry.path()));
        }
    EXPECT_THAT(contents, testing::UnorderedElementsAre("alike", "different", "right"));
    for (const char* name : {"lovelace", "noether", "hopper"})
        EXPECT_THAT(all, Not(HasSubstr(name)));
}

TEST_F(GalleryTest, RefusesWhatIsNoBatchAndWritesOverNothing) {
    EXPECT_THAT(refusal("assignments", "gallery"), HasSubstr("results.json is not there"));
    tree_.write("full/mine.txt", "");
    EXPECT_THAT(refusal("out", "full"), HasSubstr("not an empty folder"));
    tree_.write("damaged/results.json", R"({"assignment": "01-tiny", "students": [{}]})");
    EXPECT_THAT(refusal("damaged", "gallery"), HasSubstr("damaged/results.json is not as"));
    fs::remove_all(tree_ / "out/students");
    EXPECT_THAT(refusal("out", "gallery"), HasSubstr("no student in"));
    EXPECT_FALSE(fs::exists(tree_ / "gallery"));
}

}  // namespace
