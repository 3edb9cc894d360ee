// What the grader may ask of a student's projections. Every picture uses a view matrix made here,
// so that a mistake of chapter 7 costs nothing in this chapter.
#include <runner/Harness.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "Camera.h"
#include "projection.h"
#include "scene.h"

namespace {

// One scene for all frames: compiling its shader takes longer than drawing it.
course::Scene& scene() {
    static course::Scene instance;
    static const bool ready = (instance.init(), true);
    (void)ready;
    return instance;
}

struct Lens {
    float fovyDegrees, aspect, near, far;
};

// The student's projection matrix. The notes' Camera has no constructor: every member is set here.
glm::mat4 perspective(const Lens& lens) {
    Camera camera;
    camera.eye = glm::vec3(0.0f, 0.5f, 3.0f);
    camera.target = glm::vec3(0.3f, 0.1f, -0.5f);
    camera.up = glm::vec3(0.0f, 1.0f, 0.0f);
    camera.fovy = lens.fovyDegrees;
    camera.aspect = lens.aspect;
    camera.near = lens.near;
    camera.far = lens.far;
    camera.computeMatrices();
    return camera.proj;
}

float aspect(const FrameRequest& request) {
    return float(request.width) / float(request.height);
}

void draw(const glm::mat4& view, const glm::mat4& projection) {
    scene().draw(view, projection);
}

glm::mat4 viewFrom(const glm::vec3& eye) {
    return glm::lookAt(eye, glm::vec3(0.25f, 0.0f, -0.5f), glm::vec3(0.0f, 1.0f, 0.0f));
}

const glm::vec3 closeEye(-0.35f, 0.55f, 3.1f);

void drawSeededLens(const FrameRequest& request) {
    SeededValues values(request.seed);
    const Lens lens{values.uniform(45.0f, 70.0f), aspect(request), values.uniform(2.1f, 2.4f),
                    values.uniform(4.2f, 5.2f)};
    const glm::vec3 eye = closeEye + glm::vec3(values.uniform(-0.3f, 0.3f), 0.0f, 0.0f);
    draw(viewFrom(eye), perspective(lens));
}

void drawSeededBox(const FrameRequest& request) {
    SeededValues values(request.seed);
    const float height = values.uniform(2.4f, 3.2f);
    const float n = values.uniform(2.1f, 2.4f), f = values.uniform(4.4f, 5.0f);
    draw(viewFrom(closeEye), orthographic(height, aspect(request), n, f));
}

// Two rails of points p + t d, given with different w, and the point where they meet in the
// picture: the image of their common point at infinity, found by the student's functions.
void drawVanishingPoint(const FrameRequest& request) {
    const glm::mat4 view = viewFrom(closeEye);
    const glm::mat4 P = glm::perspective(glm::radians(50.0f), aspect(request), 0.1f, 100.0f);
    const glm::vec4 infinite = pointAtInfinity(glm::vec3(0.12f, 0.03f, -1.0f));
    std::vector<glm::vec3> points;
    for (int i = 0; i < 14; ++i) {
        const glm::vec3 start(i % 2 == 0 ? -0.9f : 0.7f, -0.6f, 1.2f);
        const float t = 0.9f * float(i / 2), w = 0.5f + 0.35f * float(i);
        points.push_back(dehomogenise(w * (homogenise(start) + t * infinite)));
    }
    // From the picture back into the world, to a place 3 units before the camera.
    const glm::vec3 inPicture = dehomogenise(P * view * infinite);
    const float depth = 3.0f;
    const glm::vec4 before(inPicture.x * depth / P[0][0], inPicture.y * depth / P[1][1], -depth,
                           1.0f);
    points.push_back(glm::vec3(glm::inverse(view) * before));
    scene().drawPoints(points, view, P);
}

void drawViewer(const glm::mat4& projection) {
    draw(glm::lookAt(course::viewerEye, course::viewerTarget, course::viewerUp), projection);
}

}  // namespace

CG_HARNESS(harness) {
    harness.function("perspective", [](float fovyDegrees, float aspect, float near, float far) {
        return perspective({fovyDegrees, aspect, near, far});
    });
    harness.function("orthographic", [](float height, float aspect, float n, float f) {
        return orthographic(height, aspect, n, f);
    });
    harness.function("homogenise", [](glm::vec3 p) { return homogenise(p); });
    harness.function("dehomogenise", [](glm::vec4 p) { return dehomogenise(p); });
    harness.function("pointAtInfinity", [](glm::vec3 d) { return pointAtInfinity(d); });
    harness.function("isAtInfinity", [](glm::vec4 p) { return isAtInfinity(p); });

    // The window after the key p.
    harness.frame("viewer-perspective", [](const FrameRequest& request) {
        drawViewer(perspective(
            {course::viewerFovyDegrees, aspect(request), course::viewerNear, course::viewerFar}));
    });
    harness.frame("foreshortening", [](const FrameRequest& request) {
        draw(viewFrom(closeEye), perspective({60.0f, aspect(request), 1.95f, 4.6f}));
    });
    harness.frame("wide", [](const FrameRequest& request) {
        draw(viewFrom(closeEye), perspective({45.0f, aspect(request), 1.0f, 6.0f}));
    });
    harness.frame("seeded-lens", [](const FrameRequest& request) { drawSeededLens(request); });
    harness.frame("parallel", [](const FrameRequest& request) {
        draw(viewFrom(closeEye), orthographic(2.8f, aspect(request), 2.05f, 4.7f));
    });
    harness.frame("seeded-box", [](const FrameRequest& request) { drawSeededBox(request); });
    harness.frame("vanishing-point",
                  [](const FrameRequest& request) { drawVanishingPoint(request); });
}
