// The view matrix of Camera::computeMatrices, eqs. (7.29)-(7.36). eye, target and up are set by the
// harness: no turn is involved.
#include "truth.h"

using namespace judge;
using truth::Pose;
using truth::viewOf;

namespace {

// up has length 1 and is orthogonal to eye - target.
const Pose upright = truth::generalPose;
// up is neither.
const Pose slanted{{2.0f, 1.5f, 4.0f}, {0.4f, -0.3f, 0.7f}, {0.5f, 1.3f, 0.4f}};

std::string tell(const Pose& pose) {
    return say("eye {}, target {}, up {}", pose.eye, pose.target, pose.up);
}

glm::mat4 viewFor(const Pose& pose) {
    return subject().call<glm::mat4>("view", pose.eye, pose.target, pose.up);
}

void expectView(const Pose& pose) {
    expectClose("view for " + tell(pose), viewFor(pose), viewOf(pose));
}

}  // namespace

TEST(LookAt, GeneralPosition) {
    check("view is the inverse of the camera matrix",
          "Rows of the 3x3 block are x, up, z (7.35); the last column is minus the transposed "
          "3x3 block times eye, not -eye (7.36). view[j] is column j.");
    expectView(upright);
}

TEST(LookAt, SlantedUp) {
    check("up need be neither orthogonal to the line of sight nor of length 1",
          "Subtract from up its part along z and normalise what is left, (7.30) and (7.31).");
    expectView(slanted);
}

TEST(LookAt, EyeIsTheOrigin) {
    check("the eye is the origin of the camera's coordinates, the target lies straight ahead",
          "Straight ahead is -z: the camera's z axis points to its back.");
    const glm::mat4 view = viewFor(upright);
    expectClose("view times the eye, for " + tell(upright), view * glm::vec4(upright.eye, 1.0f),
                glm::vec4(0, 0, 0, 1));
    expectClose("view times the target, for " + tell(upright),
                view * glm::vec4(upright.target, 1.0f),
                glm::vec4(0, 0, -truth::distance(upright), 1));
}

TEST(LookAt, Rigid) {
    check("the 3x3 block of view is a rotation: it neither stretches nor mirrors the world",
          "The x axis is up cross z (7.32); z cross up gives a mirrored picture.");
    const glm::mat3 block(viewFor(upright));
    expectClose("the 3x3 block of view for " + tell(upright), block, glm::mat3(viewOf(upright)));
    expectClose("V^T V of the 3x3 block V of view for " + tell(upright),
                glm::transpose(block) * block, glm::mat3(1.0f));
    expectClose("the determinant of view for " + tell(upright), glm::determinant(block), 1.0f);
}

TEST(LookAt, RightIsRight) {
    check("a step to the camera's right goes along x, a step upwards along y");
    const glm::mat4 view = viewFor(upright);
    const glm::vec3 toTheRight =
        glm::normalize(glm::cross(upright.up, upright.eye - upright.target));
    expectClose("view times a step of 2 to the camera's right, for " + tell(upright),
                view * glm::vec4(2.0f * toTheRight, 0.0f), glm::vec4(2, 0, 0, 0));
    expectClose("view times a step of 3 upwards, for " + tell(upright),
                view * glm::vec4(3.0f * upright.up, 0.0f), glm::vec4(0, 3, 0, 0));
}

TEST(LookAt, TwiceIsOnce) {
    check("a second computeMatrices gives the same view",
          "Build view from eye, target and up each time; do not multiply the old view.");
    const auto [first, second] = subject().call<std::tuple<glm::mat4, glm::mat4>>(
        "viewTwice", upright.eye, upright.target, upright.up);
    expectClose("view for " + tell(upright), first, viewOf(upright));
    expectClose("view after a second computeMatrices", second, viewOf(upright));
}

TEST(LookAt, FollowsTheCamera) {
    check("when eye, target and up change, the next view is the one of the new place");
    const Pose low{{-3.0f, 0.6f, 1.0f}, {0.2f, 0.5f, -0.6f}, {0.1f, 1.0f, 0.3f}};
    const Pose behind{{0.7f, -1.1f, -4.0f}, {-0.5f, 0.3f, 0.2f}, {-0.3f, 0.8f, 0.1f}};
    const std::vector<Pose> poses{slanted, low, behind};
    std::vector<glm::vec3> flat;
    for (const Pose& pose : poses)
        flat.insert(flat.end(), {pose.eye, pose.target, pose.up});
    const auto views = subject().call<std::vector<glm::mat4>>("viewsOnTheWay", flat);
    needCount("viewsOnTheWay", views.size(), poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        expectClose(say("view number {} on the way, for ", int(i + 1)) + tell(poses[i]),
                    views.at(i), viewOf(poses[i]));
    }
}
