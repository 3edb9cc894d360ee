#include "course/NewAssignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "Error.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::HasSubstr;
using testing_help::Tree;
using testing_help::whatOf;

std::string manifest(const std::string& id, const std::string& task) {
    return R"({"format": 1, "id": ")" + id +
           R"(", "title": "Tiny", "chapter": 1, "summary": "Small.", "submit": ["turn.cpp"],
           "inherits": {}, "limits": {}, "tasks": [{"id": ")" +
           task +
           R"(", "title": "Turn", "points": 100, "needs": [], "hint": "Turn."}],
           "frames": [], "starter_passes": []})";
}

class NewAssignmentTest : public testing::Test {
protected:
    NewAssignmentTest() {
        tree_.write("assignments/06-rotation/assignment.json", manifest("06-rotation", "turn"));
        tree_.write("solutions/06-rotation/turn.cpp", "");
        const std::string from = "grader/templates/assignment/";
        tree_.write(from + "assignments/00-skeleton/README.md",
                    "# 00 The skeleton\nThe skeleton of chapter 0: TODO(skeleton)\n");
        tree_.write(from + "assignments/00-skeleton/tests/Skeleton_test.cpp",
                    "TEST(Skeleton, Asks) {}\n");
        tree_.write(from + "solutions/00-skeleton/mistakes/skeleton-zero.cpp", "0;\n");
    }

    std::string refusal(const std::string& id) const {
        return whatOf<Error>([&] { makeAssignment(tree_.path(), id); });
    }
    /// What lies in assignments/ and solutions/ beside 06-rotation.
    int others() const {
        int count = 0;
        for (const char* folder : {"assignments", "solutions"})
            for (const auto& entry : fs::directory_iterator(tree_ / folder))
                count += entry.path().filename() == "06-rotation" ? 0 : 1;
        return count;
    }

    Tree tree_;
};

TEST_F(NewAssignmentTest, ExchangesNamesInTextsAndFileNames) {
    makeAssignment(tree_.path(), "12-skeleton-keys");
    EXPECT_EQ(readFile(tree_ / "assignments/12-skeleton-keys/README.md"),
              "# 12 Skeleton keys\nSkeleton keys of chapter 12: TODO(skeleton-keys)\n");
    EXPECT_EQ(readFile(tree_ / "assignments/12-skeleton-keys/tests/SkeletonKeys_test.cpp"),
              "TEST(SkeletonKeys, Asks) {}\n");
    EXPECT_EQ(readFile(tree_ / "solutions/12-skeleton-keys/mistakes/skeleton-keys-zero.cpp"),
              "0;\n");
    EXPECT_EQ(others(), 2);
}

TEST_F(NewAssignmentTest, RefusesNamesOfAnotherForm) {
    for (const char* id : {"", "texture", "7-texture", "12-Texture", "12-", "12-a--b", "12-a-",
                           "12_a", "../12-a", "12-a/b", "123-a", "12-3d"})
        EXPECT_THAT(refusal(id), HasSubstr("is no name for an assignment")) << id;
    EXPECT_THAT(refusal("00-texture"), HasSubstr("chapters count from 01"));
    EXPECT_EQ(others(), 0);
}

TEST_F(NewAssignmentTest, RefusesWhatIsTaken) {
    EXPECT_THAT(refusal("06-texture"), HasSubstr("the number 06 is that of 06-rotation"));
    EXPECT_THAT(refusal("12-turn"), HasSubstr("06-rotation has a task \"turn\""));
    tree_.write("reference_images/12-texture/old.png", "");
    EXPECT_THAT(refusal("12-texture"), HasSubstr("12-texture is there already"));
    EXPECT_EQ(others(), 0);
}

TEST_F(NewAssignmentTest, RefusesAStudentsCopy) {
    fs::remove_all(tree_ / "solutions");
    EXPECT_THAT(refusal("12-texture"), HasSubstr("so this is a student's copy"));
    EXPECT_FALSE(fs::exists(tree_ / "assignments/12-texture"));
}

TEST_F(NewAssignmentTest, LeavesNothingHalfWritten) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root can become the user who may write in one folder alone";
    constexpr uid_t kNobody = 65534;
    fs::permissions(tree_.path(), fs::perms(0755));
    ASSERT_EQ(chown((tree_ / "solutions").c_str(), kNobody, kNobody), 0);
    ASSERT_EQ(seteuid(kNobody), 0);
    const std::string why = refusal("12-texture");
    ASSERT_EQ(seteuid(0), 0);
    EXPECT_THAT(why, HasSubstr("assignments"));
    EXPECT_THAT(why, HasSubstr("Permission denied"));
    EXPECT_EQ(others(), 0);
}

TEST_F(NewAssignmentTest, ReplacesWhatAKilledOneLeft) {
    tree_.write("solutions/.12-texture.new/half.cpp", "");
    makeAssignment(tree_.path(), "12-texture");
    EXPECT_FALSE(fs::exists(tree_ / "solutions/12-texture/half.cpp"));
    EXPECT_EQ(others(), 2);
}

}  // namespace
