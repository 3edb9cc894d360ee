#include "truth.h"

using namespace judge;

TEST(RotateRight, DrawnTurns) {
    check("five turns to the right drawn from the seed are right");
    for (int i = 0; i < 5; ++i) {
        const glm::vec3 target = judge::random().unitVector();
        const glm::vec3 arm = judge::random().uniform(2.0f, 6.0f) * judge::random().unitVector();
        const glm::vec3 side = glm::cross(arm, judge::random().unitVector());
        const truth::Pose start = truth::posed(target, arm, side);
        truth::expectView(start, {truth::right(judge::random().angle()), truth::right(-200.0f)});
    }
}
