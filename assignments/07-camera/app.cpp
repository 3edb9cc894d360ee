// The window of this chapter: the arrow keys move your camera about its target.
#include <cg/Viewer.h>

#include "Camera.h"
#include "scene.h"

namespace {

struct CameraViewer : cg::Viewer {
    CameraViewer() : Viewer("07-camera", "Camera") {}

    void init() override {
        scene.init();
        normalScene.init();
        camera.eye_default = course::viewerEye;
        camera.target_default = course::viewerTarget;
        camera.up_default = course::viewerUp;
        camera.reset();
    }
    void draw(float aspect) override {
        camera.aspect = aspect;
        camera.computeMatrices();
        if (normals) {
            normalScene.draw(camera.view, course::projDefault(aspect));
        } else {
            scene.draw(camera.view, course::projDefault(aspect));
        }
    }
    void reset() override { camera.reset(); }
    void rotateRight(float degrees) override { camera.rotateRight(degrees); }
    void rotateUp(float degrees) override { camera.rotateUp(degrees); }

    void key(char letter) override { normals = normals != (letter == 'n'); }
    std::string keyHelp() const override {
        return "  n           the solids of normal-transform, or the cube\n";
    }

    course::Scene scene;
    course::NormalScene normalScene;
    bool normals = false;
    Camera camera;
};

}  // namespace

int main(int argc, char** argv) {
    return CameraViewer().run(argc, argv);
}
