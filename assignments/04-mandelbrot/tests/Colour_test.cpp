// The picture: c = center + zoom P (4.3), and a colour for each I(c). Which colours is the
// student's choice; the level sets are read from unclamped floats.
#include "levels.h"

using namespace judge;
using course::View;
using levels::expectPicture;

TEST(Colour, WholeSet) {
    check("at center 0 and zoom 2 the whole set is seen",
          "Every pixel of one I(c) has one colour, and I(c) and I(c) + 1 have two. A flat picture "
          "comes from dividing int by int: write float(I) / float(maxiter).");
    expectPicture(course::wholeSet);
}

TEST(Colour, OffTheAxis) {
    check("off the real axis the picture is neither mirrored nor moved",
          "c = center + zoom * canvas_coord, for both components; y grows upwards. Or two "
          "neighbouring levels have one colour.");
    expectPicture(course::crown);
    expectPicture({{-0.6f, -0.35f}, 0.9f, 40});
}

TEST(Colour, Closer) {
    check("a place between the head and the body is right in detail",
          "center is not scaled: center + zoom * P, not zoom * (center + P). Or two neighbouring "
          "levels have one colour.");
    expectPicture(course::seahorses);
}

TEST(Colour, FarAway) {
    check("with a zoom above 2 more than the whole set is seen",
          "A larger zoom shows a larger part of the plane: zoom * P, not P / zoom. Or two "
          "neighbouring levels have one colour.");
    expectPicture({{0.4f, -0.7f}, 3.1f, 26});
}

TEST(Colour, FewSteps) {
    check("with a small maxiter the picture has few levels");
    expectPicture(course::fewSteps);
    expectPicture({{-0.2f, 0.7f}, 0.8f, 8});
}

TEST(Colour, ManySteps) {
    check("with 500 steps neighbouring levels still differ, if only a little",
          "They may look alike in 8 bits. Do not round to a few shades yourself.");
    expectPicture({{-0.752f, 0.114f}, 0.06f, 500});
}

TEST(Colour, LastStep) {
    check("the level of the last step does not look like the inside",
          "Where I(c) = maxiter - 1 the iteration did leave the circle.");
    levels::expectLastStepSeen({-0.4f, 0.6f}, 0.7f, 10);
}

TEST(Colour, DrawnPlaces) {
    check("three places drawn from the seed are right");
    for (int i = 0; i < 3; ++i)
        expectPicture(course::drawnView(judge::random()));
}
