// What the grader may ask of a student's polygon.cpp: one function and three frames.
#include <runner/Harness.h>

#include "polygon.h"
#include "scene.h"

namespace {

// One scene for all frames: compiling its shader takes longer than drawing it.
course::Scene& scene() {
    static course::Scene instance;
    static const bool ready = (instance.init(), true);
    (void)ready;
    return instance;
}

void drawPolygon(const FrameRequest& request, int n) {
    std::vector<glm::vec2> corners;
    for (int i = 0; i < n; ++i) {
        corners.push_back(corner(i, n));
    }
    scene().draw(corners, float(request.width) / float(request.height));
}

}  // namespace

// AUTHOR: the names here are those of subject().call in the tests, and of "frames" in
// assignment.json. Call a student's function inside the lambda, so that a missing one costs its own
// task only.
CG_HARNESS(harness) {
    harness.function("corner", [](int i, int n) { return corner(i, n); });

    harness.frame("pentagon", [](const FrameRequest& request) { drawPolygon(request, 5); });
    harness.frame("arrow-keys", [](const FrameRequest& request) { drawPolygon(request, 7); });
    harness.frame("seeded-polygon", [](const FrameRequest& request) {
        SeededValues values(request.seed);
        drawPolygon(request, int(values.uniform(8.0f, 12.0f)));
    });
}
