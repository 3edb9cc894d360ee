#include "compare/FrameScore.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace {

using namespace grader;
using testing::HasSubstr;

constexpr double kTolerance = 0.0005;

struct Colour {
    std::uint8_t r, g, b;
};
constexpr Colour kClear{30, 40, 50}, kFace{200, 120, 40}, kBlack{0, 0, 0};

Picture flat(int width, int height, Colour colour) {
    Picture picture{width, height, {}};
    for (int i = 0; i < width * height; ++i)
        picture.rgba.insert(picture.rgba.end(), {colour.r, colour.g, colour.b, 255});
    return picture;
}

void fill(Picture& picture, int left, int top, int right, int bottom, Colour colour) {
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            std::uint8_t* pixel = const_cast<std::uint8_t*>(picture.pixel(x, y));
            pixel[0] = colour.r, pixel[1] = colour.g, pixel[2] = colour.b;
        }
}

/// A square with a darker half, `dx` to the right of where it belongs.
Picture scene(int dx = 0) {
    Picture picture = flat(200, 150, kClear);
    fill(picture, 60 + dx, 40, 120 + dx, 100, kFace);
    fill(picture, 60 + dx, 40, 90 + dx, 100, {90, 60, 20});
    return picture;
}

/// What the starter draws: the same square where it must not be.
Picture starter() {
    Picture picture = flat(200, 150, kClear);
    fill(picture, 0, 0, 40, 40, kFace);
    return picture;
}

FrameScore scoreFrame(const Picture& frame, const Picture& reference, const Picture& starter,
                      double tolerance) {
    return FrameRule({reference, {starter}, {}, tolerance}).score(frame);
}

FrameScore scored(const Picture& frame) {
    return scoreFrame(frame, scene(), starter(), kTolerance);
}

TEST(FrameScore, TheReferenceItselfIsFull) {
    const FrameScore score = scored(scene());
    EXPECT_EQ(score.score, 1);
    EXPECT_EQ(score.outliers, 0);
    EXPECT_EQ(score.meanError, 0);
}

TEST(FrameScore, WhereNothingIsSharpTheScoreIsANumberAllTheSame) {
    const auto ramp = [](bool down, int most) {
        Picture picture{200, 150, {}};
        for (int y = 0; y < 150; ++y)
            for (int x = 0; x < 200; ++x) {
                const auto grey = static_cast<std::uint8_t>(down ? most * y / 150 : most * x / 200);
                picture.rgba.insert(picture.rgba.end(), {grey, grey, grey, 255});
            }
        return picture;
    };
    const Picture reference = ramp(false, 255);
    for (const Picture& frame : {ramp(true, 255), ramp(false, 128), ramp(true, 128)}) {
        const FrameScore score = scoreFrame(frame, reference, starter(), kTolerance);
        EXPECT_GE(score.score, 0);
        EXPECT_LT(score.score, 1);
    }
    EXPECT_EQ(scoreFrame(reference, reference, starter(), kTolerance).score, 1);
}

TEST(FrameScore, AnotherDriversRoundingCostsNothing) {
    Picture noisy = scene();
    std::mt19937 engine(1);
    for (std::uint8_t& value : noisy.rgba)
        value = static_cast<std::uint8_t>(std::clamp(int(value) + int(engine() % 7) - 3, 0, 255));
    EXPECT_EQ(scored(noisy).score, 1);
}

TEST(FrameScore, AnEdgeThatMovedByAPixelCostsNothing) {
    EXPECT_EQ(scored(scene(1)).score, 1);
    EXPECT_EQ(scored(scene(-1)).score, 1);
}

// Looking for a match in one direction only would not see what is thinner than the neighbourhood.
TEST(FrameScore, AThinLineCountsWhenItIsMissingAndWhenItIsTooMuch) {
    Picture lined = scene();
    fill(lined, 10, 20, 190, 21, {255, 255, 255});
    const double share = 180.0 / (200 * 150);
    EXPECT_NEAR(scoreFrame(scene(), lined, {}, kTolerance).outliers, share, share / 10);
    EXPECT_NEAR(scoreFrame(lined, scene(), {}, kTolerance).outliers, share, share / 10);
}

TEST(FrameScore, AnEdgeThatMovedFurtherCostsMoreTheFurtherItMoved) {
    const double two = scored(scene(2)).score, five = scored(scene(5)).score;
    EXPECT_LT(two, 1);
    EXPECT_GT(two, 0.9);
    EXPECT_LT(five, two);
    EXPECT_GT(five, 0.5);
    EXPECT_LT(scored(scene(30)).score, five);
}

TEST(FrameScore, AlphaIsNotLookedAt) {
    Picture other = scene();
    for (std::size_t i = 3; i < other.rgba.size(); i += 4)
        other.rgba[i] = 0;
    EXPECT_EQ(scored(other).score, 1);
}

TEST(FrameScore, PicturesThatTakeNoWorkEarnNothing) {
    Colour mean{};
    {
        double sum[3] = {};
        const Picture reference = scene();
        for (std::size_t i = 0; i < reference.rgba.size(); ++i)
            if (i % 4 != 3)
                sum[i % 4] += reference.rgba[i];
        const double pixels = 200.0 * 150.0;
        mean = {static_cast<std::uint8_t>(std::lround(sum[0] / pixels)),
                static_cast<std::uint8_t>(std::lround(sum[1] / pixels)),
                static_cast<std::uint8_t>(std::lround(sum[2] / pixels))};
    }
    EXPECT_EQ(scored(flat(200, 150, kClear)).score, 0) << "blank";
    EXPECT_EQ(scored(flat(200, 150, kBlack)).score, 0) << "black";
    EXPECT_EQ(scored(flat(200, 150, mean)).score, 0) << "mean colour";
    EXPECT_EQ(scored(starter()).score, 0) << "the starter's frame";
    EXPECT_EQ(scored(flat(200, 150, {255, 0, 255})).score, 0);
}

// The bar is the best of the baselines, here the starter's: a blank frame is further away.
TEST(FrameScore, ANearStarterRaisesTheBar) {
    const Picture near = scene(6);
    const FrameScore ofStarter = scoreFrame(near, scene(), near, kTolerance);
    EXPECT_EQ(ofStarter.score, 0);
    EXPECT_GT(scored(near).score, 0);
    const FrameScore better = scoreFrame(scene(3), scene(), near, kTolerance);
    EXPECT_GT(better.score, 0);
    EXPECT_LT(better.score, scored(scene(3)).score);
}

TEST(FrameScore, HalfRightIsInBetween) {
    Picture half = flat(200, 150, kClear);
    fill(half, 60, 40, 90, 100, {90, 60, 20});
    const FrameScore score = scored(half);
    EXPECT_GT(score.score, 0.3);
    EXPECT_LT(score.score, 0.7);
    EXPECT_GT(score.score, scored(starter()).score);
}

TEST(FrameScore, WhatIsNearlyAllThereIsFullAndWhatIsNotStaysBelow) {
    // 200 x 150 pixels: 15 may differ in any case.
    Picture frame = scene();
    for (int i = 0; i < 15; ++i)
        fill(frame, 5 + 10 * i, 5, 6 + 10 * i, 6, {255, 255, 255});
    EXPECT_EQ(scored(frame).score, 1);
    fill(frame, 150, 110, 170, 130, {255, 255, 255});
    const FrameScore score = scored(frame);
    EXPECT_LE(score.score, 0.99) << "what is not everything must not read as everything";
    EXPECT_GT(score.score, 0.5);
}

TEST(FrameScore, TheDeadZoneEndsAboveFour) {
    EXPECT_EQ(scoreFrame(flat(20, 20, {104, 100, 100}), flat(20, 20, {100, 100, 100}), {}, 0).score,
              1);
    EXPECT_EQ(
        scoreFrame(flat(20, 20, {105, 100, 100}), flat(20, 20, {100, 100, 100}), {}, 0).outliers,
        1);
}

TEST(FrameScore, TheErrorIsFullFromSixtyFour) {
    const auto errorAt = [](std::uint8_t value) {
        const Colour middle{100, 100, 100};
        return scoreFrame(flat(9, 9, {std::uint8_t(100 + value), 100, 100}), flat(9, 9, middle), {},
                          0)
            .meanError;
    };
    EXPECT_EQ(errorAt(4), 0);
    EXPECT_NEAR(errorAt(34), 0.5, 1e-6);
    EXPECT_NEAR(errorAt(64), 1, 1e-6);
    EXPECT_NEAR(errorAt(155), 1, 1e-6);
}

TEST(FrameScore, AnotherSizeEarnsNothingAndSaysSo) {
    const Picture other = flat(150, 200, kClear);
    const FrameScore score = scored(other);
    EXPECT_EQ(score.score, 0);
    EXPECT_FALSE(score.sizeMatches);
    EXPECT_EQ(score.sentence, "expected 200 x 150 pixels, got 150 x 200");
    EXPECT_EQ(scored({200, 150, {1, 2, 3}}).score, 0) << "a lie about its size";
    EXPECT_EQ(scored({}).score, 0);
}

TEST(FrameScore, TheSentenceHasTheShareThePlaceAndTheWay) {
    Picture frame = scene();
    fill(frame, 150, 110, 200, 150, {255, 255, 255});
    const FrameScore score = scored(frame);
    EXPECT_NEAR(score.outliers, 50.0 * 40 / (200 * 150), 0.01);
    EXPECT_NEAR(score.centreX, 175, 2);
    EXPECT_NEAR(score.centreY, 130, 2);
    const std::string text = score.sentence;
    EXPECT_THAT(text, HasSubstr("of the pixels differ, mostly in the bottom right"));
    EXPECT_THAT(text, HasSubstr("% of the way from the starter's to the right one"));
    const Picture blank = flat(200, 150, kClear);
    EXPECT_THAT(scored(blank).sentence,
                HasSubstr("12.0 % of the pixels differ, mostly in the middle; the picture is no "
                          "nearer to the right one than the starter's"));
}

TEST(FrameScore, TheDifferenceIsWhiteWhereItIsWrong) {
    Picture frame = scene();
    fill(frame, 150, 110, 200, 150, {255, 255, 255});
    const Picture difference = differenceOf(frame, scene());
    ASSERT_TRUE(difference.sameSizeAs(frame));
    EXPECT_EQ(difference.pixel(170, 130)[0], 255);
    EXPECT_EQ(difference.pixel(170, 130)[2], 255);
    EXPECT_EQ(difference.pixel(10, 10)[1], 0);
    EXPECT_EQ(difference.pixel(10, 10)[3], 255) << "opaque";
    const Picture all = differenceOf(flat(3, 3, kBlack), scene());
    EXPECT_TRUE(all.sameSizeAs(scene()));
    EXPECT_EQ(all.pixel(0, 0)[0], 255);
}

}  // namespace
