#include "truth.h"

using namespace judge;

TEST(Homogeneous, DrawnPoints) {
    check("five points drawn from the seed come back from any w");
    for (int i = 0; i < 5; ++i) {
        const glm::vec3 p = judge::random().uniform(1.0f, 5.0f) * judge::random().unitVector();
        const float w = judge::random().uniform(-3.0f, -0.3f);
        const auto homogeneous = subject().call<glm::vec4>("homogenise", p);
        expectClose(say("homogenise({})", p), homogeneous, glm::vec4(p, 1.0f));
        const glm::vec4 scaled = w * glm::vec4(p, 1.0f);
        expectClose(say("dehomogenise({})", scaled),
                    subject().call<glm::vec3>("dehomogenise", scaled), p);
    }
}
