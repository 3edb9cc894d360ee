// The window of this chapter: figure 9.1, drawn by your Scene::draw.
#include <cg/Viewer.h>

#include "Scene.inl"
#include "Table.h"
#include "figure.h"

namespace {

struct SceneViewer : cg::Viewer {
    SceneViewer() : Viewer("09-scene-graph", "Scene graph") {}

    void init() override {
        course::buildFigure(figure);
        course::look(figure, course::front);
        course::use(look, figure);
        addTable();
        course::look(alone, course::atTheTable);
        course::use(look, alone);
    }
    void draw(float aspect) override {
        course::prepare(scene(), aspect);
        scene().draw();
    }
    void reset() override { scene().camera->reset(); }
    void rotateRight(float degrees) override { scene().camera->rotateRight(degrees); }
    void rotateUp(float degrees) override { scene().camera->rotateUp(degrees); }

    void key(char letter) override {
        if (letter == 'm') {
            look = look == course::Look::normals ? course::Look::materials : course::Look::normals;
            course::use(look, figure);
            course::use(look, alone);
        } else if (letter == 't') {
            tableOnly = !tableOnly;
        }
    }
    std::string keyHelp() const override {
        return "  m           materials or normals\n"
               "  t           your table alone, or figure 9.1\n";
    }

private:
    // The world of the second scene holds nothing but the table of Table.cpp.
    void addTable() {
        alone.geometry["cube"] = new Cube;
        alone.geometry["cube"]->init();
        alone.material["wood"] = new Material(*figure.material["wood"]);
        alone.model["piece"] = new Model{alone.geometry["cube"], alone.material["wood"]};
        for (const char* name : {"table", "top", "leg"}) {
            alone.node[name] = new Node;
        }
        buildTable(*alone.node["table"], *alone.node["top"], *alone.node["leg"],
                   alone.model["piece"], {1.7f, 1.1f, 0.9f}, 0.12f);
        course::connect(alone.node["world"], alone.node["table"], glm::mat4(1.0f));
    }

    Scene& scene() { return tableOnly ? alone : figure; }

    Scene figure, alone;
    course::Look look = course::Look::normals;
    bool tableOnly = false;
};

}  // namespace

int main(int argc, char** argv) {
    return SceneViewer().run(argc, argv);
}
