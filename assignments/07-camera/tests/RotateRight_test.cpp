// Camera::rotateRight (section 7.6.1): eye turns about the axis through target along up.
#include "truth.h"

using namespace judge;
using truth::defaultPose;
using truth::expectEye;
using truth::expectView;
using truth::generalPose;
using truth::Pose;
using truth::right;

TEST(RotateRight, DefaultCamera) {
    check("from the default camera, rotateRight(90) brings the eye to (0, 0, -5)");
    expectView(defaultPose, {right(90.0f)});
}

TEST(RotateRight, GeneralPosition) {
    check("rotateRight turns the eye about the target, wherever the target is",
          "Turn eye - target, not eye, and add target again afterwards.");
    expectEye(generalPose, {right(25.0f)});
}

TEST(RotateRight, KeepsTheTarget) {
    check("rotateRight leaves the target where it is");
    const Pose got = expectEye(generalPose, {right(70.0f)});
    expectClose("target after " + truth::tell(generalPose, {right(70.0f)}), got.target,
                generalPose.target);
}

TEST(RotateRight, KeepsTheDistance) {
    check("rotateRight keeps the distance between eye and target");
    const Pose got = expectEye(generalPose, {right(110.0f)});
    expectClose("|eye - target| after " + truth::tell(generalPose, {right(110.0f)}),
                truth::distance(got), truth::distance(generalPose));
}

TEST(RotateRight, NegativeTurnsLeft) {
    check("a negative angle turns to the left, and back again");
    expectEye(generalPose, {right(-40.0f)});
    expectEye(generalPose, {right(-40.0f), right(65.0f)});
}

TEST(RotateRight, StepsAddUp) {
    check("four steps of 25 degrees show what one of 100 degrees shows");
    expectView(generalPose, {right(25.0f), right(25.0f), right(25.0f), right(25.0f)});
}

TEST(RotateRight, AfterATurnUp) {
    check("after the camera was turned up, rotateRight turns about the new up",
          "The axis is the camera's own up, not the world's y axis.");
    expectView(truth::turned(generalPose, {truth::up(55.0f)}), {right(35.0f)});
}
