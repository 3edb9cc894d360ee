#include "truth.h"

using namespace judge;

TEST(EulerRodrigues, DrawnTurns) {
    check("five turns drawn from the seed are right");
    for (int i = 0; i < 5; ++i) {
        const float degrees = judge::random().angle();
        truth::expectRotation("eulerRodrigues", degrees, judge::random().unitVector());
    }
}
