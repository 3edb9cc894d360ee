// The window of this chapter: the arrow keys move your camera about its target.
#include <cg/Viewer.h>

#include "Camera.h"
#include "scene.h"

namespace {

struct CameraViewer : cg::Viewer {
    CameraViewer() : Viewer("07-camera", "Camera") {}

    void init() override {
        scene.init();
        camera.eye_default = course::viewerEye;
        camera.target_default = course::viewerTarget;
        camera.up_default = course::viewerUp;
        camera.reset();
    }
    void draw(float aspect) override {
        camera.aspect = aspect;
        camera.computeMatrices();
        scene.draw(camera.view, course::projDefault(aspect));
    }
    void reset() override { camera.reset(); }
    void rotateRight(float degrees) override { camera.rotateRight(degrees); }
    void rotateUp(float degrees) override { camera.rotateUp(degrees); }

    course::Scene scene;
    Camera camera;
};

}  // namespace

int main(int argc, char** argv) {
    return CameraViewer().run(argc, argv);
}
