// The right projections and the corners of what they show, computed in the judge.
#pragma once

#include <subject/Judge.h>

#include <glm/gtc/matrix_transform.hpp>

namespace truth {

struct Lens {
    float fovyDegrees, aspect, near, far;
};

struct Box {
    float height, aspect, near, far;
};

inline std::string tell(const Lens& lens) {
    return judge::say("fovy {}, aspect {}, near {}, far {}", lens.fovyDegrees, lens.aspect,
                      lens.near, lens.far);
}

inline std::string tell(const Box& box) {
    return judge::say("orthographic({}, {}, {}, {})", box.height, box.aspect, box.near, box.far);
}

/// eq. (8.23)
inline glm::mat4 projection(const Lens& lens) {
    return glm::mat4(glm::perspective(glm::radians(double(lens.fovyDegrees)), double(lens.aspect),
                                      double(lens.near), double(lens.far)));
}

inline glm::mat4 projection(const Box& box) {
    const double top = 0.5 * box.height, right = top * box.aspect;
    return glm::mat4(glm::ortho(-right, right, -top, top, double(box.near), double(box.far)));
}

/// The corner of what the camera sees that lands on `ndc`, whose components are -1 or 1; in camera
/// coordinates, eq. (8.12).
inline glm::vec3 corner(const Lens& lens, const glm::vec3& ndc) {
    const float distance = ndc.z < 0.0f ? lens.near : lens.far;
    const float top = distance * std::tan(0.5f * glm::radians(lens.fovyDegrees));
    return {ndc.x * lens.aspect * top, ndc.y * top, -distance};
}

inline glm::vec3 corner(const Box& box, const glm::vec3& ndc) {
    const float top = 0.5f * box.height;
    return {ndc.x * box.aspect * top, ndc.y * top, -(ndc.z < 0.0f ? box.near : box.far)};
}

/// Where a point in camera coordinates lands in normalised device coordinates.
inline glm::vec3 project(const glm::mat4& P, const glm::vec3& point) {
    const glm::vec4 clip = P * glm::vec4(point, 1.0f);
    return glm::vec3(clip) / clip.w;
}

/// The student's projection.
inline glm::mat4 projectionByStudent(const Lens& lens) {
    return judge::subject().call<glm::mat4>("perspective", lens.fovyDegrees, lens.aspect, lens.near,
                                            lens.far);
}

inline glm::mat4 projectionByStudent(const Box& box) {
    return judge::subject().call<glm::mat4>("orthographic", box.height, box.aspect, box.near,
                                            box.far);
}

/// Compares the student's projection with the truth and returns it. All entries are of the size of
/// 1: near and far are like 1 and 6.
template <class LensOrBox>
glm::mat4 expectProjection(const LensOrBox& seen) {
    const glm::mat4 P = projectionByStudent(seen);
    judge::expectClose("the projection for " + tell(seen), P, projection(seen));
    return P;
}

/// Where the point of a frustum or box lands in the picture: x and y, or depth, alone.
template <class LensOrBox>
void expectPlace(const LensOrBox& seen, const glm::vec3& point) {
    const glm::vec3 got = project(projectionByStudent(seen), point);
    judge::expectClose(judge::say("x and y of {} in the picture for ", point) + tell(seen),
                       glm::vec2(got), glm::vec2(project(projection(seen), point)));
}

template <class LensOrBox>
void expectDepth(const LensOrBox& seen, float distance, float expected) {
    const glm::vec3 got = project(projectionByStudent(seen), {0.1f, 0.2f, -distance});
    judge::expectClose(judge::say("depth at distance {} for ", distance) + tell(seen), got.z,
                       expected);
}

/// All eight corners of the lens or box land on the corners of the viewing box.
template <class LensOrBox>
void expectCorners(const glm::mat4& P, const LensOrBox& seen) {
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 ndc(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        const glm::vec3 point = corner(seen, ndc);
        judge::expectClose(judge::say("where the corner {} lands, for ", point) + tell(seen),
                           project(P, point), ndc);
    }
}

/// Depth is right and grows from near to far.
template <class LensOrBox>
void expectDepthOrder(const LensOrBox& seen) {
    const glm::mat4 P = projectionByStudent(seen);
    float previous = -2.0f;
    for (int i = 0; i <= 4; ++i) {
        const float distance = seen.near + 0.25f * float(i) * (seen.far - seen.near);
        const glm::vec3 point(0.1f, 0.2f, -distance);
        const float depth = project(P, point).z;
        judge::expectClose(judge::say("depth at distance {} for ", distance) + tell(seen), depth,
                           project(projection(seen), point).z);
        judge::expectThat(judge::say("depth at distance {} for ", distance) + tell(seen),
                          depth > previous,
                          judge::say("{} is not more than {} before it", depth, previous));
        previous = depth;
    }
}

}  // namespace truth
