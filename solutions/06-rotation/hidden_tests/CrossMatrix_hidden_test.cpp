#include "truth.h"

using namespace judge;

TEST(CrossMatrix, DrawnVectors) {
    check("five pairs of vectors drawn from the seed have the right cross product");
    for (int i = 0; i < 5; ++i) {
        const glm::vec3 u = judge::random().uniform(0.5f, 4.0f) * judge::random().unitVector();
        const glm::vec3 v = judge::random().uniform(0.5f, 4.0f) * judge::random().unitVector();
        const auto M = subject().call<glm::mat3>("crossMatrix", u);
        expectClose(say("crossMatrix({}) times {}", u, v), M * v, glm::cross(u, v));
    }
}
