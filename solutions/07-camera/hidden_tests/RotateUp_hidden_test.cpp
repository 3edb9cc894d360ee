#include "truth.h"

using namespace judge;

TEST(RotateUp, DrawnTurns) {
    check("five flights over the pole drawn from the seed are right");
    for (int i = 0; i < 5; ++i) {
        const glm::vec3 target = judge::random().unitVector();
        const glm::vec3 arm = judge::random().uniform(2.0f, 6.0f) * judge::random().unitVector();
        const glm::vec3 side = glm::cross(arm, judge::random().unitVector());
        const truth::Pose start = truth::posed(target, arm, side);
        const float first = judge::random().uniform(30.0f, 70.0f);
        truth::expectView(start, {truth::up(first), truth::up(60.0f), truth::up(-150.0f)});
    }
}
