// The right turns and the right view matrix, computed in the judge.
#pragma once

#include <subject/Judge.h>

#include <glm/gtc/matrix_transform.hpp>
#include <tuple>
#include <vector>

namespace truth {

struct Pose {
    glm::vec3 eye, target, up;
};

/// (0, degrees) is rotateRight(degrees), (1, degrees) is rotateUp(degrees).
using Steps = std::vector<glm::vec2>;
inline glm::vec2 right(float degrees) {
    return {0.0f, degrees};
}
inline glm::vec2 up(float degrees) {
    return {1.0f, degrees};
}

/// What reset() gives with the default values of code 8.1.
inline const Pose defaultPose{{5, 0, 0}, {0, 0, 0}, {0, 1, 0}};

/// A pose that hides nothing: the target off the origin in all three directions, up slanted. up is
/// orthogonal to eye - target, because only then rotateRight has one reading.
inline Pose posed(const glm::vec3& target, const glm::vec3& arm, const glm::vec3& roughUp) {
    const glm::vec3 z = glm::normalize(arm);
    return {target + arm, target, glm::normalize(roughUp - glm::dot(roughUp, z) * z)};
}
inline const Pose generalPose = posed({0.4f, -0.3f, 0.7f}, {1.6f, 1.8f, 3.3f}, {0.2f, 1.0f, -0.3f});

inline glm::mat4 viewOf(const Pose& pose) {
    return glm::lookAt(pose.eye, pose.target, pose.up);
}

/// The right pose after some turns.
inline Pose turned(Pose pose, const Steps& steps) {
    for (const glm::vec2& step : steps) {
        const glm::vec3 arm = pose.eye - pose.target;
        const bool isUp = step.x != 0.0f;
        const glm::dvec3 axis(isUp ? glm::normalize(glm::cross(arm, pose.up))
                                   : glm::normalize(pose.up));
        const glm::mat3 R(glm::rotate(glm::dmat4(1.0), glm::radians(double(step.y)), axis));
        pose.eye = pose.target + R * arm;
        if (isUp)
            pose.up = R * pose.up;
    }
    return pose;
}

/// The student's pose after some turns.
inline Pose turnedByStudent(const Pose& start, const Steps& steps) {
    const auto [eye, target, up] =
        judge::subject().call<std::tuple<glm::vec3, glm::vec3, glm::vec3>>(
            "turn", start.eye, start.target, start.up, steps);
    return {eye, target, up};
}

/// "rotateRight(25), rotateUp(-10) from eye (1, 2, 3), target (0, 0, 0)"
inline std::string tell(const Pose& start, const Steps& steps) {
    std::string text;
    for (const glm::vec2& step : steps) {
        text += text.empty() ? "" : ", ";
        text += judge::say(step.x == 0.0f ? "rotateRight({})" : "rotateUp({})", step.y);
    }
    return text + judge::say(" from eye {}, target {}", start.eye, start.target);
}

/// Turns the student's camera and compares where the eye is. Returns the student's pose.
inline Pose expectEye(const Pose& start, const Steps& steps) {
    const Pose got = turnedByStudent(start, steps);
    judge::expectClose("eye after " + tell(start, steps), got.eye, turned(start, steps).eye);
    return got;
}

/// Fails where up and eye - target are parallel: what such a camera sees hangs on rounding.
inline bool expectUpAside(const Pose& start, const Steps& steps, const Pose& got) {
    const glm::dvec3 arm(got.eye - got.target), up(got.up);
    const double sine = glm::length(glm::cross(glm::normalize(arm), glm::normalize(up)));
    return judge::expectThat("up after " + tell(start, steps), sine >= 1e-3,
                             judge::say("expected {}, got {}, which is parallel to eye - target",
                                        turned(start, steps).up, got.up));
}

/// Turns the student's camera and compares what it sees. The view matrix is the judge's own, made
/// from the student's eye, target and up: a mistake in computeMatrices costs nothing here.
inline Pose expectView(const Pose& start, const Steps& steps) {
    const Pose got = expectEye(start, steps);
    if (!expectUpAside(start, steps, got))
        return got;
    judge::expectClose("the view (made from your eye, target and up) after " + tell(start, steps),
                       viewOf(got), viewOf(turned(start, steps)), 2e-4f);
    return got;
}

inline float distance(const Pose& pose) {
    return glm::length(pose.eye - pose.target);
}

}  // namespace truth
