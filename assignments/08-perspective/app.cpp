// The window of this chapter: your camera of 07-camera; p switches to your perspective.
#include <cg/Viewer.h>

#include "Camera.h"
#include "projection.h"
#include "scene.h"

using namespace course;

struct PerspectiveViewer : cg::Viewer {
    PerspectiveViewer() : Viewer("08-perspective", "Perspective") {}

    void init() override {
        scene.init();
        camera.eye_default = viewerEye;
        camera.target_default = viewerTarget;
        camera.up_default = viewerUp;
        camera.fovy_default = viewerFovyDegrees;
        camera.near_default = viewerNear;
        camera.far_default = viewerFar;
        camera.reset();
    }
    void draw(float aspect) override {
        camera.aspect = aspect;
        camera.computeMatrices();
        const auto box = orthographic(viewerOrthoHeight, aspect, viewerOrthoNear, viewerOrthoFar);
        scene.draw(camera.view, perspective() ? camera.proj : box);
    }
    void reset() override { camera.reset(); }
    void rotateRight(float degrees) override { camera.rotateRight(degrees); }
    void rotateUp(float degrees) override { camera.rotateUp(degrees); }
    bool hasPerspective() const override { return true; }

    Scene scene;
    Camera camera;
};

int main(int argc, char** argv) {
    return PerspectiveViewer().run(argc, argv);
}
