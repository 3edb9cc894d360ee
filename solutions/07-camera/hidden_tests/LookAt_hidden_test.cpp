#include "truth.h"

using namespace judge;

TEST(LookAt, DrawnPoses) {
    check("five poses drawn from the seed give the right view");
    for (int i = 0; i < 5; ++i) {
        const glm::vec3 target = judge::random().unitVector();
        const glm::vec3 arm = judge::random().uniform(2.0f, 6.0f) * judge::random().unitVector();
        // Some direction away from the line of sight, then slanted towards it.
        const glm::vec3 side = glm::normalize(glm::cross(arm, judge::random().unitVector()));
        const glm::vec3 up = judge::random().uniform(0.5f, 3.0f) * side + 0.3f * arm;
        const truth::Pose pose{target + arm, target, up};
        const auto view = subject().call<glm::mat4>("view", pose.eye, pose.target, pose.up);
        expectClose(say("view for eye {}, target {}, up {}", pose.eye, pose.target, pose.up), view,
                    truth::viewOf(pose));
    }
}
