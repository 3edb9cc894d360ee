// orthographic(height, aspect, n, f): its box lands on [-1, 1]^3. The handout fixes the signature.
#include "truth.h"

using namespace judge;
using truth::Box;
using truth::expectDepth;
using truth::expectPlace;
using truth::expectProjection;

namespace {

const Box box{3.0f, 1.6f, 1.0f, 6.0f};

}  // namespace

TEST(Orthographic, KnownBox) {
    check("orthographic(3, 1.6, 1, 6) is the right matrix");
    expectProjection(box);
}

TEST(Orthographic, EightCorners) {
    check("the eight corners of the box land on the corners of the viewing box");
    const Box other{2.5f, 1.25f, 0.5f, 4.5f};
    truth::expectCorners(expectProjection(other), other);
}

TEST(Orthographic, NearAndFar) {
    check("camera z = -n lands on depth -1 and z = -f on +1",
          "The camera looks along -z while depth grows forwards: the z scale is negative.");
    expectDepth(box, box.near, -1.0f);
    expectDepth(box, box.far, 1.0f);
}

TEST(Orthographic, AspectIsWidthOverHeight) {
    check("the box is aspect * height wide, in a tall picture and in a wide one",
          "The scale of x is 2 / (aspect * height), that of y is 2 / height.");
    expectPlace(Box{3.0f, 0.7f, 1.0f, 6.0f}, {0.4f, 0.6f, -3.0f});
    expectPlace(Box{3.0f, 2.1f, 1.0f, 6.0f}, {0.4f, 0.6f, -3.0f});
}

TEST(Orthographic, FartherIsDeeper) {
    check("what is farther away has the larger depth");
    truth::expectDepthOrder(Box{1.5f, 1.5f, 2.0f, 4.5f});
}

TEST(Orthographic, SameSizeEverywhere) {
    check("things look equally large at every distance: w stays 1");
    expectPlace(box, {0.3f, 0.2f, -2.0f});
    expectPlace(box, {0.3f, 0.2f, -5.0f});
    const glm::vec4 point(0.3f, 0.2f, -5.0f, 1.0f);
    expectClose(say("w of the projected {} for ", point) + tell(box),
                (truth::projectionByStudent(box) * point).w, 1.0f);
}

TEST(Orthographic, BehindTheCamera) {
    check("n may be negative: the box then begins behind the camera");
    expectProjection(Box{4.0f, 1.25f, -2.0f, 7.0f});
}
