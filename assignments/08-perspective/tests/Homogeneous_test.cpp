// homogenise, dehomogenise, pointAtInfinity and isAtInfinity, section 8.2.4.
#include "truth.h"

using namespace judge;

namespace {

void expectPoint(const glm::vec4& p, const glm::vec3& expected) {
    expectClose(say("dehomogenise({})", p), subject().call<glm::vec3>("dehomogenise", p), expected);
}

}  // namespace

TEST(Homogeneous, PointsHaveWOne) {
    check("homogenise gives the point a fourth component of 1");
    const glm::vec3 p(1.5f, -2.0f, 0.5f);
    expectClose(say("homogenise({})", p), subject().call<glm::vec4>("homogenise", p),
                glm::vec4(p, 1.0f));
}

TEST(Homogeneous, DividesByW) {
    check("dehomogenise divides x, y and z by w",
          "(8.8): the point of (x, y, z, w) is (x, y, z)/w.");
    expectPoint({3.0f, -5.0f, 1.0f, 2.0f}, {1.5f, -2.5f, 0.5f});
    expectPoint({0.5f, 1.0f, -0.25f, 0.25f}, {2.0f, 4.0f, -1.0f});
}

TEST(Homogeneous, NegativeW) {
    check("a negative w is divided out like any other");
    expectPoint({3.0f, -5.0f, 1.0f, -1.0f}, {-3.0f, 5.0f, -1.0f});
    expectPoint({1.0f, 2.0f, -6.0f, -4.0f}, {-0.25f, -0.5f, 1.5f});
}

TEST(Homogeneous, InfinityStaysAsItIs) {
    check("dehomogenise divides a point by w and leaves a point at infinity as it is",
          "For w = 0 there is nothing to divide by: return x, y, z.");
    expectPoint({4.0f, -2.0f, 6.0f, 2.0f}, {2.0f, -1.0f, 3.0f});
    expectPoint({4.0f, -2.0f, 6.0f, 0.0f}, {4.0f, -2.0f, 6.0f});
}

TEST(Homogeneous, DirectionsHaveWZero) {
    check("pointAtInfinity keeps the direction and sets w to 0",
          "The direction is not normalised: (2, -3, 6) becomes (2, -3, 6, 0).");
    const glm::vec3 direction(2, -3, 6);
    expectClose(say("pointAtInfinity({})", direction),
                subject().call<glm::vec4>("pointAtInfinity", direction),
                glm::vec4(direction, 0.0f));
}

TEST(Homogeneous, TellsPointsFromDirections) {
    check("isAtInfinity is true for w = 0 and false for every other w");
    for (const float w : {0.0f, 1.0f, 0.25f, -2.0f}) {
        const glm::vec4 p(1.0f, 2.0f, -3.0f, w);
        const bool infinite = subject().call<bool>("isAtInfinity", p);
        expectThat(say("isAtInfinity({})", p), infinite == (w == 0.0f),
                   say("expected {}, got {}", w == 0.0f, infinite));
    }
}

TEST(Homogeneous, ThereAndBack) {
    check("any multiple of homogenise(p) stands for p again");
    const glm::vec3 p = 3.0f * judge::random().unitVector();
    const auto q = subject().call<glm::vec4>("homogenise", p);
    expectClose(say("homogenise({})", p), q, glm::vec4(p, 1.0f));
    expectPoint(2.5f * q, p);
    expectPoint(-0.5f * q, p);
}
