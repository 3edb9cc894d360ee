// What the grader may ask of a student's rotation.cpp: three functions and five frames.
#include <runner/Harness.h>

#include "rotation.h"
#include "scene.h"

namespace {

// One scene for all frames: compiling its shader takes longer than drawing it.
course::Scene& scene() {
    static course::Scene instance;
    static const bool ready = (instance.init(), true);
    (void)ready;
    return instance;
}

float aspect(const FrameRequest& request) {
    return float(request.width) / float(request.height);
}

void drawBody(const FrameRequest& request, const glm::mat3& pose) {
    scene().drawBody(pose, aspect(request));
}

void drawWhirl(const FrameRequest& request) {
    scene().drawWhirl(crossMatrix(glm::vec3(0.3f, 1.1f, -0.5f)), aspect(request));
}

// What the window shows after the keys left, left, down: each key turns what the last one left.
void drawArrowKeys(const FrameRequest& request) {
    const glm::vec3 x(1.0f, 0.0f, 0.0f), y(0.0f, 1.0f, 0.0f);
    drawBody(request, rotation(10.0f, x) * rotation(-10.0f, y) * rotation(-10.0f, y));
}

void drawSeededTurn(const FrameRequest& request) {
    SeededValues values(request.seed);
    const float degrees = values.uniform(80.0f, 150.0f);
    const glm::vec3 axis = values.unitVector();
    drawBody(request, rotation(degrees, axis));
}

void drawThreeBodies(const FrameRequest& request) {
    SeededValues values(request.seed);
    const float degrees = values.uniform(80.0f, 150.0f);
    const glm::vec3 axis = values.unitVector();
    const glm::mat3 poses[3] = {
        eulerRodrigues(100.0f, glm::vec3(1.0f, 2.0f, 3.0f)),
        eulerRodrigues(-130.0f, glm::vec3(-2.0f, 1.0f, 0.5f)),
        eulerRodrigues(degrees, axis),
    };
    scene().drawThreeBodies(poses, aspect(request));
}

}  // namespace

CG_HARNESS(harness) {
    harness.function("crossMatrix", [](glm::vec3 u) { return crossMatrix(u); });
    harness.function("rotation",
                     [](float degrees, glm::vec3 axis) { return rotation(degrees, axis); });
    harness.function("eulerRodrigues",
                     [](float degrees, glm::vec3 axis) { return eulerRodrigues(degrees, axis); });

    harness.frame("whirl", [](const FrameRequest& request) { drawWhirl(request); });
    harness.frame("turned", [](const FrameRequest& request) {
        drawBody(request, rotation(100.0f, glm::vec3(1.0f, 2.0f, 3.0f)));
    });
    harness.frame("arrow-keys", [](const FrameRequest& request) { drawArrowKeys(request); });
    harness.frame("seeded-turn", [](const FrameRequest& request) { drawSeededTurn(request); });
    harness.frame("three-bodies", [](const FrameRequest& request) { drawThreeBodies(request); });
}
