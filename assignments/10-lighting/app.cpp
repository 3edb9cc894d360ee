// The window of this chapter: a still life under three lamps, or one coarse sphere shaded in three
// ways, both by your shader.
#include <cg/Viewer.h>

#include <iostream>

#include "Camera.h"
#include "comparison.h"
#include "scene.h"

namespace {

struct LightingViewer : cg::Viewer {
    LightingViewer() : Viewer("10-lighting", "Lighting") {}

    void init() override {
        set.init();
        comparison.init();
        course::StillLife::place(camera);
    }
    void draw(float aspect) override {
        camera.aspect = aspect;
        camera.computeMatrices();
        if (sideBySide) {
            comparison.draw(set, camera.view, camera.proj, course::StillLife::lamps(), plaster);
        } else {
            course::StillLife(set).draw(camera.view, camera.proj, course::StillLife::lamps());
        }
    }
    void reset() override { camera.reset(); }
    void rotateRight(float degrees) override { camera.rotateRight(degrees); }
    void rotateUp(float degrees) override { camera.rotateUp(degrees); }

    void key(char letter) override {
        if (letter == 'g') {
            sideBySide = !sideBySide;
            std::cout << (sideBySide ? "flat, Gouraud and Phong shading" : "still life")
                      << std::endl;
        } else if (letter == 'l') {
            set.shader.enablelighting = set.shader.enablelighting ? GL_FALSE : GL_TRUE;
            std::cout << "lighting: " << (set.shader.enablelighting ? "on" : "off") << std::endl;
        } else if (letter == 'a') {
            approach(0.9f);
        } else if (letter == 'z') {
            approach(1.0f / 0.9f);
        }
    }
    std::string keyHelp() const override {
        return "  a, z        closer, farther\n"
               "  g           flat, Gouraud and Phong shading side by side, or the still life\n"
               "  l           lighting on or off\n";
    }

private:
    void approach(float factor) {
        const glm::vec3 arm = factor * (camera.eye - camera.target);
        if (glm::length(arm) > 1.0f && glm::length(arm) < 30.0f) {
            camera.eye = camera.target + arm;
        }
    }

    course::Set set;
    course::Comparison comparison;
    Camera camera;
    Material plaster = course::material({0.1f, 0.1f, 0.1f}, {0.6f, 0.55f, 0.5f}, {0.5f, 0.5f, 0.5f},
                                        glm::vec3(0.0f), 12.0f);
    bool sideBySide = false;
};

}  // namespace

int main(int argc, char** argv) {
    return LightingViewer().run(argc, argv);
}
