#include "subject/Judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace {
std::vector<std::string> failures;  // what a check would have been told
struct {
    std::string what;
    std::vector<std::vector<double>> expected, got;
} comparison;  // what a report would show
}  // namespace

namespace judge {
void fail(const std::string& sentence) {
    failures.push_back(sentence);
}
namespace detail {
void compared(const std::string& what, std::vector<std::vector<double>> expected,
              std::vector<std::vector<double>> got, double) {
    comparison = {what, std::move(expected), std::move(got)};
}
}  // namespace detail
}  // namespace judge

namespace {

using namespace judge;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class Expecting : public testing::Test {
protected:
    Expecting() { failures.clear(); }
};

TEST(Show, WritesValuesAsStudentsDo) {
    EXPECT_EQ(show(true), "true");
    EXPECT_EQ(show(-3), "-3");
    EXPECT_EQ(show(0.5f), "0.5");
    EXPECT_EQ(show(1.0f / 3), "0.3333");
    EXPECT_EQ(show(-0.0f), "0");
    EXPECT_EQ(show(kNaN), "nan");
    EXPECT_EQ(show(glm::vec2(1, 2)), "(1, 2)");
    EXPECT_EQ(show(glm::vec3(1, -2.5, 3)), "(1, -2.5, 3)");
    EXPECT_EQ(show(glm::vec4(1, 2, 3, 4)), "(1, 2, 3, 4)");
}

TEST(Show, WritesMatricesByRows) {
    glm::mat3 matrix(0.0f);
    matrix[2][0] = 5;  // column 2, row 0
    EXPECT_EQ(show(matrix), "[0 0 5; 0 0 0; 0 0 0]");
    glm::mat4 larger(1.0f);
    larger[3] = glm::vec4(7, 8, 9, 1);
    EXPECT_EQ(show(larger), "[1 0 0 7; 0 1 0 8; 0 0 1 9; 0 0 0 1]");
}

TEST(Say, PutsValuesIntoASentence) {
    EXPECT_EQ(say("rotation({}, {}) of {}", 90.0f, glm::vec3(0, 1, 0), "x"),
              "rotation(90, (0, 1, 0)) of x");
}

TEST_F(Expecting, EqualValuesAgree) {
    EXPECT_TRUE(expectClose("a", 1.0f, 1.0f));
    EXPECT_TRUE(expectClose("b", glm::mat4(2), glm::mat4(2)));
    EXPECT_THAT(failures, IsEmpty());
}

TEST_F(Expecting, TheSentenceHasExpectedAndGot) {
    EXPECT_FALSE(expectClose("eye after rotateUp(90)", glm::vec3(1, 2, 3), glm::vec3(1, 2, 4)));
    EXPECT_THAT(failures, ElementsAre("eye after rotateUp(90): expected (1, 2, 4), got (1, 2, 3)"));
}

TEST_F(Expecting, TheToleranceIsRelativeAboveOneAndAbsoluteBelow) {
    EXPECT_TRUE(expectClose("a", 1000.05f, 1000.0f));
    EXPECT_FALSE(expectClose("b", 1000.2f, 1000.0f));
    EXPECT_TRUE(expectClose("c", 0.00005f, 0.0f));
    EXPECT_FALSE(expectClose("d", 0.0002f, 0.0f));
    EXPECT_TRUE(expectClose("e", 1.4f, 1.0f, 0.5f));
    EXPECT_EQ(failures.size(), 2u);
}

TEST_F(Expecting, OneWrongComponentIsEnough) {
    glm::mat4 wrong(1.0f);
    wrong[3][2] = 0.01f;
    EXPECT_FALSE(expectClose("m", wrong, glm::mat4(1.0f)));
}

TEST_F(Expecting, WhatIsNoNumberNeverAgrees) {
    EXPECT_FALSE(expectClose("a", kNaN, 1.0f));
    EXPECT_FALSE(expectClose("b", glm::vec3(1, kNaN, 1), glm::vec3(1)));
    EXPECT_FALSE(expectClose("c", glm::vec3(kNaN, 1, 1), glm::vec3(1)));
    EXPECT_FALSE(expectClose("d", glm::vec3(1, 1, kNaN), glm::vec3(1)));
    EXPECT_FALSE(expectClose("e", kInfinity, 1.0f));
    EXPECT_FALSE(expectClose("f", glm::mat3(kNaN), glm::mat3(1.0f)));
    EXPECT_EQ(failures[1], "b: expected (1, 1, 1), got (1, nan, 1)");
}

TEST_F(Expecting, AConditionSaysWhatWasFound) {
    EXPECT_TRUE(expectThat("the determinant is 1", true, "it is 1"));
    EXPECT_FALSE(expectThat("the determinant is 1", false, "it is -1"));
    EXPECT_THAT(failures, ElementsAre("the determinant is 1: it is -1"));
}

}  // namespace
