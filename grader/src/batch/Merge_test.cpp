// Parts of a class put together, and marks repeated.

#include "batch/Merge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "batch/Replay.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_help::Tree;

class MergeTest : public testing::Test {
protected:
    static Mark mark(const std::string& id, double points) {
        Mark one;
        one.student.id = id;
        one.status = points < 0 ? "missing" : "graded";
        one.submission = points < 0 ? "" : id + "-work";
        one.points = std::max(points, 0.0);
        one.maxPoints = 100;
        one.tasks = {{"rotation", one.points, one.points, 100, false, ""}};
        return one;
    }
    /// A part as a batch writes it.
    fs::path part(const std::string& name, std::vector<Mark> marks, std::uint64_t seed = 7,
                  const std::string& cpu = "a", const std::string& assignment = "06-rotation") {
        Manifest manifest;
        manifest.id = assignment;
        const std::vector<std::string> none, everybody = {"ann", "bob", "cy", "dan"};
        const Overview overview{manifest, marks, none, {}, everybody, seed, Json{{"cpu", cpu}}};
        tree_.write(name + "/results.json", overview.json());
        for (const Mark& each : marks)
            if (!each.submission.empty())
                tree_.write(name + "/students/" + each.submission + "/result.json", "{}");
        return tree_ / name;
    }
    static std::vector<std::string> pointsOf(const Merged& merged) {
        std::vector<std::string> all;
        for (const Mark& each : merged.marks)
            all.push_back(fmt::format("{} {:g}", each.student.id, each.points));
        return all;
    }
    std::string complaintAbout(const std::vector<fs::path>& parts) {
        try {
            readParts(parts);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    Tree tree_;
};

TEST_F(MergeTest, AnyOrderAndPartsGivenTwiceAreTheSame) {
    const fs::path one = part("one", {mark("ann", 50), mark("dan", -1)});
    const fs::path two = part("two", {mark("bob", 60), mark("dan", -1)});
    const Merged merged = readParts({one, two});
    EXPECT_THAT(pointsOf(merged), ElementsAre("ann 50", "bob 60", "dan 0"));
    EXPECT_THAT(merged.missing, ElementsAre("cy")) << "in no part";
    EXPECT_THAT(merged.notTaken, IsEmpty());
    EXPECT_EQ(pointsOf(readParts({two, one, two})), pointsOf(merged));
    copyFolders(merged, tree_ / "all");
    copyFolders(merged, tree_ / "all");
    EXPECT_TRUE(fs::exists(tree_ / "all/students/ann-work/result.json"));
    EXPECT_TRUE(fs::exists(tree_ / "all/students/bob-work/result.json"));
}

TEST_F(MergeTest, WhatDoesNotAgreeIsRefused) {
    const fs::path one = part("one", {mark("ann", 50)});
    EXPECT_THAT(complaintAbout({one, part("two", {mark("ann", 40)})}),
                HasSubstr("ann has graded with 40 points here, and graded with 50 points"));
    EXPECT_THAT(complaintAbout({one, part("two", {mark("bob", 40)}, 8)}),
                HasSubstr("another seed"));
    EXPECT_THAT(complaintAbout({one, part("two", {mark("bob", 40)}, 7, "a", "07-camera")}),
                HasSubstr("holds results of 07-camera"));
    EXPECT_THAT(complaintAbout({one, tree_ / "three"}), HasSubstr("results.json is not there"));
    EXPECT_EQ(complaintAbout({one, part("two", {mark("ann", -1)})}), "")
        << "a part that has not seen the submission knows less";
}

TEST_F(MergeTest, WhatIsNotWholeIsNamed) {
    tree_.write("three/results.json", R"({"assignment": "06-rotation"})");
    EXPECT_THAT(complaintAbout({tree_ / "three"}),
                AllOf(HasSubstr("three/results.json is not as ./grade batch wrote it"),
                      HasSubstr("'seed'"), HasSubstr("run the same ./grade batch again")));
    tree_.write("three/results.json", R"({"assignment": "06-)");
    EXPECT_THAT(complaintAbout({tree_ / "three"}), HasSubstr("three/results.json is not as"));
    const fs::path four = part("four", {mark("ann", 50)});
    tree_.write("four/students/ann-work/result.json", R"({"tasks": [{}]})");
    EXPECT_THAT(complaintAbout({four}), HasSubstr("ann-work/result.json is not as"));
}

TEST_F(MergeTest, OtherMachinesAreSaid) {
    const Merged merged =
        readParts({part("one", {mark("ann", 50)}), part("two", {mark("bob", 60)}, 7, "b")});
    EXPECT_THAT(merged.notTaken,
                ElementsAre(HasSubstr("different machines: cpu is a in one and b in another")));
}

TEST(Marks, ComeBackFromTheirJson) {
    Mark mark;
    mark.student = {"1", "Ann", "a@x", "S"};
    mark.submission = "ann";
    mark.status = "graded";
    mark.tasks = {{"rotation", 10, 20, 45, false, "a person"}};
    mark.automatic = 10;
    mark.points = 16;
    mark.maxPoints = 45;
    mark.lateness = {true, 2, 20, "2 days late"};
    mark.warnings = {"look"};
    EXPECT_EQ(jsonOf(markFrom(jsonOf(mark))), jsonOf(mark));
}

Json documentWith(double points, const std::string& status, const std::string& cpu = "a") {
    return {{"status", "graded"},
            {"points", points},
            {"environment", {{"cpu", cpu}, {"glm", "0.9.9"}}},
            {"tasks", {{{"checks", {{{"id", "A.B"}, {"status", status}, {"points", points}}}}}}}};
}

TEST(Replay, NamesWhatDiffers) {
    EXPECT_THAT(differencesOf(documentWith(5, "pass"), documentWith(5, "pass", "b")), IsEmpty());
    EXPECT_THAT(differencesOf(documentWith(5, "pass"), documentWith(4, "partial")),
                ElementsAre("A.B: then pass with 5 points, now partial with 4 points"));
    Json broken = documentWith(0, "fail");
    broken["status"] = "build_error";
    broken["tasks"] = Json::array();
    EXPECT_THAT(differencesOf(documentWith(5, "pass"), broken),
                ElementsAre("then graded, now build_error", "A.B is not checked any more"));
    EXPECT_THAT(changesOfEnvironment(documentWith(5, "pass"), documentWith(5, "pass", "b")),
                ElementsAre("cpu: then a, now b"));
}

}  // namespace
