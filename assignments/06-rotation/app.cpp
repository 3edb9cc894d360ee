// The window of this chapter: the arrow keys turn the body by your rotation(), each from where the
// last one left it.
#include <cg/Viewer.h>

#include "rotation.h"
#include "scene.h"

namespace {

struct RotationViewer : cg::Viewer {
    RotationViewer() : Viewer("06-rotation", "Rotation") {}

    void init() override { scene.init(); }
    void draw(float aspect) override { scene.drawBody(pose, aspect); }
    void reset() override { pose = glm::mat3(1.0f); }

    // A camera that moves one way shows the body turned the other way.
    void rotateRight(float degrees) override {
        pose = rotation(-degrees, glm::vec3(0.0f, 1.0f, 0.0f)) * pose;
    }
    void rotateUp(float degrees) override {
        pose = rotation(degrees, glm::vec3(1.0f, 0.0f, 0.0f)) * pose;
    }

    course::Scene scene;
    glm::mat3 pose = glm::mat3(1.0f);
};

}  // namespace

int main(int argc, char** argv) {
    return RotationViewer().run(argc, argv);
}
