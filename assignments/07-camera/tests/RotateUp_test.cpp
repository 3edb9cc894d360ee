// Camera::rotateUp (section 7.6.1): eye and up turn about the axis through target that is
// orthogonal to both up and eye - target; positive angles bring the eye towards up.
#include "truth.h"

using namespace judge;
using truth::defaultPose;
using truth::expectEye;
using truth::expectView;
using truth::generalPose;
using truth::Pose;
using truth::up;

TEST(RotateUp, DefaultCamera) {
    check("from the default camera, rotateUp(90) brings the eye to (0, 5, 0) and up to (-1, 0, 0)");
    expectView(defaultPose, {up(90.0f)});
}

TEST(RotateUp, GeneralPosition) {
    check("rotateUp turns the eye about the target, towards up",
          "Turn eye - target, not eye; if the eye sinks, the axis points the other way.");
    expectEye(generalPose, {up(25.0f)});
}

TEST(RotateUp, KeepsTheTarget) {
    check("rotateUp leaves the target where it is");
    const Pose got = expectEye(generalPose, {up(35.0f)});
    expectClose("target after " + truth::tell(generalPose, {up(35.0f)}), got.target,
                generalPose.target);
}

TEST(RotateUp, KeepsTheDistance) {
    check("rotateUp keeps the distance between eye and target",
          "If the distance changes, the axis given to your rotation may not have length 1.");
    const Pose got = expectEye(generalPose, {up(60.0f)});
    expectClose("|eye - target| after " + truth::tell(generalPose, {up(60.0f)}),
                truth::distance(got), truth::distance(generalPose));
}

TEST(RotateUp, NegativeTurnsDown) {
    check("a negative angle turns down, and back again");
    expectView(generalPose, {up(-30.0f)});
    expectView(generalPose, {up(-30.0f), up(75.0f)});
}

TEST(RotateUp, OverThePole) {
    check("three steps of 50 degrees carry the camera over the pole",
          "up must turn together with eye, or the second step turns about a wrong axis.");
    expectView(generalPose, {up(50.0f), up(50.0f), up(50.0f)});
}

TEST(RotateUp, ThenRight) {
    check("after rotateUp, a turn to the right goes round the camera's new up",
          "up must turn together with eye: rotateRight turns about it afterwards.");
    const truth::Steps upwards{up(40.0f)};
    const Pose got = expectEye(generalPose, upwards);
    // The turn to the right is the judge's, so that only rotateUp is judged.
    const Pose then = truth::turned(got, {truth::right(30.0f)});
    const Pose expected = truth::turned(generalPose, {up(40.0f), truth::right(30.0f)});
    expectClose(
        "eye after " + truth::tell(generalPose, upwards) + " and a right turn by 30 degrees",
        then.eye, expected.eye);
}
