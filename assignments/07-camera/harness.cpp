// What the grader may ask of a student's camera. A check of a turn never rests on the student's
// view matrix, and a check of the view matrix never on a turn, so each mistake is charged once.
#include <cg/ShaderProbe.h>
#include <runner/Harness.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <tuple>
#include <vector>

#include "Camera.h"
#include "scene.h"

namespace {

// One scene for all frames: compiling its shader takes longer than drawing it.
course::Scene& scene() {
    static course::Scene instance;
    static const bool ready = (instance.init(), true);
    (void)ready;
    return instance;
}

// Its own, so that a shader that does not compile spoils no other picture.
course::NormalScene& normalScene() {
    static course::NormalScene instance;
    static const bool ready = (instance.init(), true);
    (void)ready;
    return instance;
}

// The notes' Camera has no constructor: every member is set here.
Camera cameraAt(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.up = up;
    camera.fovy = 30.0f;
    camera.aspect = 4.0f / 3.0f;
    camera.near = 0.01f;
    camera.far = 100.0f;
    return camera;
}

// Each step is (0, degrees) for rotateRight or (1, degrees) for rotateUp.
using Steps = std::vector<glm::vec2>;

Camera turned(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up,
              const Steps& steps) {
    Camera camera = cameraAt(eye, target, up);
    for (const glm::vec2& step : steps) {
        if (step.x == 0.0f) {
            camera.rotateRight(step.y);
        } else {
            camera.rotateUp(step.y);
        }
    }
    return camera;
}

void draw(const FrameRequest& request, const glm::mat4& view) {
    scene().draw(view, course::projDefault(float(request.width) / float(request.height)));
}

// The picture from where the student's turns led, with the right view matrix.
void drawTurned(const FrameRequest& request, const Camera& camera) {
    draw(request, glm::lookAt(camera.eye, camera.target, camera.up));
}

// The picture with the student's view matrix.
void drawLookAt(const FrameRequest& request, const glm::vec3& eye, const glm::vec3& target,
                const glm::vec3& up) {
    Camera camera = cameraAt(eye, target, up);
    camera.computeMatrices();
    draw(request, camera.view);
}

// A start in general position: the target off the origin in all three directions, the eye
// 1.5 units away from it, up slanted and orthogonal to eye - target, so that rotateRight has
// one reading.
const glm::vec3 offTarget(-0.4f, -0.2f, 0.35f);
const glm::vec3 offArm(0.85f, 0.55f, 1.15f);
const glm::vec3 offEye = offTarget + offArm;
const glm::vec3 yAxis(0.0f, 1.0f, 0.0f);
const glm::vec3 offUp =
    glm::normalize(yAxis - glm::dot(yAxis, offArm) / glm::dot(offArm, offArm) * offArm);

// The window after left, left, down. The two turns to the right are done here, so that the
// picture shows rotateUp alone.
void drawArrowKeys(const FrameRequest& request) {
    const glm::mat4 right = glm::rotate(glm::mat4(1.0f), glm::radians(20.0f), yAxis);
    const glm::vec3 arm(right * glm::vec4(course::viewerEye - course::viewerTarget, 0.0f));
    const glm::vec3 eye = course::viewerTarget + arm;
    drawTurned(request, turned(eye, course::viewerTarget, course::viewerUp, {{1, 10.0f}}));
}

void drawSeededTurn(const FrameRequest& request) {
    SeededValues values(request.seed);
    const float first = values.uniform(60.0f, 90.0f), second = values.uniform(150.0f, 170.0f);
    drawTurned(request, turned(offEye, offTarget, offUp, {{0, first}, {0, second}}));
}

void drawSeededView(const FrameRequest& request) {
    SeededValues values(request.seed);
    const float azimuth = values.uniform(2.4f, 3.9f), height = values.uniform(1.2f, 2.5f);
    const glm::vec3 eye(4.0f * std::sin(azimuth), height, 4.0f * std::cos(azimuth));
    const float slantX = values.uniform(-0.6f, 0.6f), slantZ = values.uniform(-0.6f, 0.6f);
    const glm::vec3 up(slantX, 2.0f, slantZ);
    drawLookAt(request, eye, offTarget, up);
}

}  // namespace

CG_HARNESS(harness) {
    harness.function("turn", [](glm::vec3 eye, glm::vec3 target, glm::vec3 up, Steps steps) {
        const Camera camera = turned(eye, target, up, steps);
        return std::make_tuple(camera.eye, camera.target, camera.up);
    });
    harness.function("view", [](glm::vec3 eye, glm::vec3 target, glm::vec3 up) {
        Camera camera = cameraAt(eye, target, up);
        camera.computeMatrices();
        return camera.view;
    });
    harness.function("viewTwice", [](glm::vec3 eye, glm::vec3 target, glm::vec3 up) {
        Camera camera = cameraAt(eye, target, up);
        camera.computeMatrices();
        const glm::mat4 first = camera.view;
        camera.computeMatrices();
        return std::make_tuple(first, camera.view);
    });
    // One camera at three places, one after the other: poses holds eye, target, up of each.
    harness.function("viewsOnTheWay", [](std::vector<glm::vec3> poses) {
        Camera camera = cameraAt(poses.at(0), poses.at(1), poses.at(2));
        std::vector<glm::mat4> views;
        for (std::size_t i = 0; i + 2 < poses.size(); i += 3) {
            camera.eye = poses[i];
            camera.target = poses[i + 1];
            camera.up = poses[i + 2];
            camera.computeMatrices();
            views.push_back(camera.view);
        }
        return views;
    });

    // What transformed_normal.vert makes of normals, one modelview after the other.
    harness.function(
        "normals", [](std::vector<glm::mat4> modelviews, std::vector<glm::vec3> normals) {
            std::vector<glm::vec3> transformed;
            for (std::size_t i = 0; i < modelviews.size(); ++i) {
                cg::Uniforms uniforms;
                uniforms.mat4s = {{"modelview", modelviews[i]}, {"projection", glm::mat4(1.0f)}};
                const std::vector<glm::vec4> position{glm::vec4(0.3f, -0.2f, 0.5f, 1.0f)};
                const std::vector<glm::vec4> normal{glm::vec4(normals.at(i), 0.0f)};
                transformed.push_back(glm::vec3(cg::probeVertex("shaders/transformed_normal.vert",
                                                                {{0, position}, {1, normal}},
                                                                "normal", uniforms)[0]));
            }
            return transformed;
        });

    harness.frame("from-the-right", [](const FrameRequest& request) {
        drawTurned(request, turned(offEye, offTarget, offUp, {{0, 230.0f}}));
    });
    harness.frame("seeded-turn", [](const FrameRequest& request) { drawSeededTurn(request); });
    harness.frame("arrow-keys", [](const FrameRequest& request) { drawArrowKeys(request); });
    harness.frame("over-the-pole", [](const FrameRequest& request) {
        drawTurned(request, turned(offEye, offTarget, offUp, {{1, 40.0f}, {1, 40.0f}, {1, 40.0f}}));
    });
    harness.frame("slanted-up", [](const FrameRequest& request) {
        drawLookAt(request, glm::vec3(-2.0f, 1.9f, -3.2f), offTarget, glm::vec3(0.5f, 1.2f, 0.3f));
    });
    harness.frame("seeded-view", [](const FrameRequest& request) { drawSeededView(request); });
    harness.frame("stretched-normals", [](const FrameRequest& request) {
        const glm::mat4 view = glm::lookAt(glm::vec3(1.2f, 1.0f, 2.6f), glm::vec3(0.0f), yAxis);
        normalScene().draw(view, course::projDefault(float(request.width) / float(request.height)));
    });
}
