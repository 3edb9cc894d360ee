// The proj of Camera::computeMatrices, eq. (8.23). The lens is set by the harness; near and far are
// like 1 and 6, because with 0.01 and 100 a wrong depth is invisible.
#include "truth.h"

using namespace judge;
using truth::expectDepth;
using truth::expectPlace;
using truth::expectProjection;
using truth::Lens;
using truth::project;

namespace {

const Lens lens{40.0f, 1.6f, 1.0f, 6.0f};

}  // namespace

TEST(Perspective, KnownLens) {
    check("proj for fovy 40, aspect 1.6, near 1, far 6 is the matrix of eq. (8.23)");
    expectProjection(lens);
}

TEST(Perspective, EightCorners) {
    check("the eight corners of the viewing frustum land on the corners of the viewing box",
          "Compare with (8.12) and (8.19): E lands on (1, 1, -1) and A on (1, 1, 1).");
    const Lens other{55.0f, 1.25f, 1.5f, 5.0f};
    truth::expectCorners(expectProjection(other), other);
}

TEST(Perspective, NearAndFar) {
    check("the near plane lands on depth -1 and the far plane on +1",
          "OpenGL's depth goes from -1 to 1: (3,3) is -(f+n)/(f-n) and (3,4) is -2fn/(f-n).");
    expectDepth(lens, lens.near, -1.0f);
    expectDepth(lens, lens.far, 1.0f);
}

TEST(Perspective, VerticalFieldOfView) {
    check("fovy is the whole vertical angle, in degrees",
          "tan wants radians, and half of the angle is above the axis, half below.");
    // The upper edge of the picture at distance 3.
    const Lens wide{75.0f, 1.0f, 1.0f, 6.0f}, narrow{35.0f, 1.0f, 1.0f, 6.0f};
    expectPlace(wide, {0.0f, 3.0f * std::tan(glm::radians(37.5f)), -3.0f});
    expectPlace(narrow, {0.0f, 3.0f * std::tan(glm::radians(17.5f)), -3.0f});
}

TEST(Perspective, AspectIsWidthOverHeight) {
    check("aspect stretches x alone: 0.7 for a tall picture, 2.1 for a wide one",
          "aspect stands in the (1,1) entry only, under the fraction bar.");
    expectPlace(Lens{50.0f, 0.7f, 1.0f, 6.0f}, {0.6f, 0.8f, -3.0f});
    expectPlace(Lens{50.0f, 2.1f, 1.0f, 6.0f}, {0.6f, 0.8f, -3.0f});
}

TEST(Perspective, FartherIsSmaller) {
    check("at twice the distance everything looks half as large",
          "x and y are divided by w, which is the distance: proj[2][3] = -1.");
    const glm::vec3 close(0.3f, 0.2f, -2.0f), away(0.3f, 0.2f, -4.0f);
    expectPlace(lens, close);
    expectPlace(lens, away);
    const glm::mat4 P = truth::projectionByStudent(lens);
    expectClose("twice x and y of (0.3, 0.2, -4) for " + tell(lens),
                2.0f * glm::vec2(project(P, away)), glm::vec2(project(P, close)));
}

TEST(Perspective, FartherIsDeeper) {
    check("what is farther away has the larger depth");
    truth::expectDepthOrder(Lens{30.0f, 1.5f, 2.0f, 4.5f});
}

TEST(Perspective, WIsTheDistance) {
    check("the fourth component of a projected point is its distance before the camera",
          "The last row is (0, 0, -1, 0): proj[2][3] = -1 and proj[3][3] = 0.");
    const glm::vec4 point(0.5f, -0.4f, -2.5f, 1.0f);
    expectClose(say("w of proj times {} for ", point) + tell(lens),
                (truth::projectionByStudent(lens) * point).w, 2.5f);
}
