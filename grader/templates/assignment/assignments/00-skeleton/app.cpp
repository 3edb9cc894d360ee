// The window of this chapter: the arrow keys change the number of corners.
#include <cg/Viewer.h>

#include <algorithm>

#include "polygon.h"
#include "scene.h"

namespace {

// AUTHOR: the window. cg/Viewer.h says which keys it knows and what you may override.
struct PolygonViewer : cg::Viewer {
    PolygonViewer() : Viewer("00-skeleton", "The skeleton") {}

    void init() override { scene.init(); }
    void draw(float aspect) override {
        std::vector<glm::vec2> corners;
        for (int i = 0; i < count; ++i) {
            corners.push_back(corner(i, count));
        }
        scene.draw(corners, aspect);
    }
    void reset() override { count = 5; }

    void arrow(int, int up) override { count = std::clamp(count + up, 3, 12); }
    std::string arrowHelp() const override { return "one corner more or less"; }

    course::Scene scene;
    int count = 5;
};

}  // namespace

int main(int argc, char** argv) {
    return PolygonViewer().run(argc, argv);
}
