// The window of this chapter: the keys fly over the complex plane.
#include <cg/Viewer.h>

#include <algorithm>
#include <array>
#include <iostream>

#include "scene.h"

namespace {

struct MandelbrotViewer : cg::Viewer {
    MandelbrotViewer() : Viewer("04-mandelbrot", "Mandelbrot", 500, 500) {}

    void init() override { scene.init(); }

    // The largest square in the middle of the window, so that nothing is stretched.
    void draw(float) override {
        std::array<GLint, 4> whole{};
        glGetIntegerv(GL_VIEWPORT, whole.data());
        const GLint side = std::min(whole[2], whole[3]);
        glViewport((whole[2] - side) / 2, (whole[3] - side) / 2, side, side);
        scene.draw();
    }

    void reset() override {
        scene.shader.center = glm::vec2(0.0f);
        scene.shader.zoom = 2.0f;
        scene.shader.maxiter = 50;
    }

    void arrow(int right, int up) override {
        scene.shader.center += 0.1f * scene.shader.zoom * glm::vec2(float(right), float(up));
    }
    std::string arrowHelp() const override { return "move by a twentieth of the picture"; }

    void key(char letter) override {
        MandelbrotShader& shader = scene.shader;
        switch (letter) {
            case 'a':
                shader.zoom *= 0.9f;
                break;
            case 'z':
                shader.zoom /= 0.9f;
                break;
            case '+':
            case '=':
                shader.maxiter += 10;
                break;
            case '-':
                shader.maxiter = std::max(10, shader.maxiter - 10);
                break;
            default:
                return;
        }
        std::cout << "center " << shader.center.x << " + " << shader.center.y << " i, zoom "
                  << shader.zoom << ", maxiter " << shader.maxiter << std::endl;
    }
    std::string keyHelp() const override {
        return "  a, z        closer, farther\n"
               "  +, -        10 iterations more, fewer\n";
    }

    course::Scene scene;
};

}  // namespace

int main(int argc, char** argv) {
    return MandelbrotViewer().run(argc, argv);
}
