#include "truth.h"

using namespace judge;

TEST(Rotation, DrawnTurns) {
    check("five turns drawn from the seed are right");
    for (int i = 0; i < 5; ++i) {
        const float degrees = judge::random().angle();
        truth::expectRotation("rotation", degrees, judge::random().unitVector());
    }
}

TEST(Rotation, DrawnAxesOfAnyLength) {
    check("five turns about axes of any length, drawn from the seed, are right");
    for (int i = 0; i < 5; ++i) {
        const float degrees = judge::random().uniform(-350.0f, -190.0f);
        truth::expectRotation("rotation", degrees,
                              judge::random().uniform(2.0f, 9.0f) * judge::random().unitVector());
    }
}
