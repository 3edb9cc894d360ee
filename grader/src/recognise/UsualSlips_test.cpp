#include "recognise/UsualSlips.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace grader;
using testing::HasSubstr;

/// What is said when each of these right answers came as the one beside it.
std::string saidOf(const std::vector<std::pair<Evidence, Evidence>>& answers) {
    std::vector<AnswerPair> pairs;
    for (const auto& [right, got] : answers)
        pairs.push_back({right, got});
    return usualSlip(pairs).value_or("nothing");
}

Evidence value(const std::string& type, std::vector<double> numbers) {
    return {"key", "ok", type, std::move(numbers)};
}

/// Turns about z, columns first, as GLM stores them.
Evidence turn(double radians) {
    const double c = std::cos(radians), s = std::sin(radians);
    return value("mat3", {c, s, 0, -s, c, 0, 0, 0, 1});
}

TEST(UsualSlips, Transposed) {
    EXPECT_THAT(saidOf({{value("mat3", {1, 2, 3, 4, 5, 6, 7, 8, 10}),
                         value("mat3", {1, 4, 7, 2, 5, 8, 3, 6, 10})}}),
                HasSubstr("transpose"));
}

TEST(UsualSlips, Inverse) {
    EXPECT_THAT(saidOf({{value("mat3", {2, 0, 0, 0, 4, 0, 0, 3, 1}),
                         value("mat3", {0.5, 0, 0, 0, 0.25, 0, 0, -0.75, 1})}}),
                HasSubstr("inverse of the right one: it maps the other way"));
}

TEST(UsualSlips, ARotationTheOtherWayMayBeEither) {
    EXPECT_THAT(saidOf({{turn(0.5), turn(-0.5)}}), HasSubstr("either rows and columns"));
}

TEST(UsualSlips, DegreesForRadians) {
    constexpr double kDegree = 0.017453292519943295;
    EXPECT_THAT(saidOf({{turn(0.5), turn(0.5 * kDegree)}}), HasSubstr("as many degrees"));
    EXPECT_THAT(saidOf({{turn(0.5 * kDegree), turn(0.5)}, {turn(kDegree), turn(1)}}),
                HasSubstr("as many radians"));
}

TEST(UsualSlips, NoNumbers) {
    const double nan = std::nan("");
    EXPECT_THAT(saidOf({{value("float", {0.5}), value("float", {0.5})},
                        {value("vec3", {0, 0, 0}), value("vec3", {nan, nan, 0})}}),
                HasSubstr("nan or inf"));
    EXPECT_EQ(saidOf({{value("vec3", {nan, 0, 0}), value("vec3", {nan, 0, 1})}}), "nothing")
        << "where none is right, none is wrong";
}

TEST(UsualSlips, Negated) {
    EXPECT_THAT(saidOf({{value("vec3", {1, 2, 3}), value("vec3", {-1, -2, -3})},
                        {value("vec3", {0, 5, 1}), value("vec3", {0, -5, -1})}}),
                HasSubstr("opposite sign"));
}

TEST(UsualSlips, NotNormalised) {
    EXPECT_THAT(saidOf({{value("vec3", {0.6, 0.8, 0}), value("vec3", {3, 4, 0})},
                        {value("vec3", {0, 0, 1}), value("vec3", {0, 0, 2})}}),
                HasSubstr("normalise"));
}

TEST(UsualSlips, OffByOne) {
    std::vector<std::pair<Evidence, Evidence>> answers;
    for (const double each : {3, 8, 0, 17})
        answers.push_back({value("int", {each}), value("int", {each + 1})});
    EXPECT_THAT(saidOf(answers), HasSubstr("one too large"));
}

TEST(UsualSlips, SwappedAxes) {
    EXPECT_THAT(saidOf({{value("vec3", {1, 2, 3}), value("vec3", {1, 3, 2})},
                        {value("vec3", {4, 9, 6}), value("vec3", {4, 6, 9})}}),
                HasSubstr("you have xzy"));
}

TEST(UsualSlips, AnswersWithoutNumbersTellNothing) {
    EXPECT_THAT(saidOf({{value("list", {}), value("list", {})},
                        {value("vec4", {1, 2, 3, 4}), value("vec4", {2, 4, 6, 8})}}),
                HasSubstr("2 times"));
    EXPECT_EQ(saidOf({{value("list", {}), value("list", {})}}), "nothing");
}

TEST(UsualSlips, NothingIsSaidOfOneVectorOrOfMixedErrors) {
    EXPECT_EQ(saidOf({{value("vec3", {1, 2, 3}), value("vec3", {-1, -2, -3})}}), "nothing");
    EXPECT_EQ(saidOf({{value("vec3", {1, 2, 3}), value("vec3", {-1, -2, -3})},
                      {value("vec3", {0, 5, 1}), value("vec3", {5, 0, 1})}}),
              "nothing");
    EXPECT_EQ(saidOf({{turn(0.5), {"key", "died", "", {}}}}), "nothing");
    EXPECT_EQ(saidOf({{turn(0.5), turn(0.5)}}), "nothing");
}

}  // namespace
