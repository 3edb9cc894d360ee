// What the grader may ask of a student's scene graph. Graphs come from the judge as lists of
// numbers; the harness turns them into nodes, calls Scene::draw, and the census sees what is drawn.
#include <cg/NormalShader.h>
#include <runner/Harness.h>

#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

#include "Cube.h"
#include "Scene.inl"
#include "Sphere.h"
#include "Table.h"
#include "Torus.h"
#include "figure.h"
#include "print_watch.h"
#include "table_view.h"

namespace {

using Ints = std::vector<int>;
using Vectors = std::vector<glm::vec3>;
using Colors = std::vector<glm::vec4>;
using Matrices = std::vector<glm::mat4>;

// A scene graph as numbers. Node 0 is the world. Each edge is two numbers, parent and child; each
// hanging model three, its node, geometry and material. A material is five vec4: ambient, diffuse,
// specular, emision, and shininess in the last one's x. The camera is eye, target and up.
struct Graph {
    int nodes;
    Ints edges;
    Matrices childtransforms;
    Ints hanging;
    Matrices modeltransforms;
    Colors materials;
    Vectors camera;
};

// The scene in which every graph is built anew. Its geometry and shader stay: they are dear.
class Stage {
public:
    Stage() {
        scene.geometry["0"] = new Cube;
        scene.geometry["1"] = new Torus;
        scene.geometry["2"] = new Sphere;
        for (auto& [name, geometry] : scene.geometry) {
            geometry->init();
        }
        course::use(course::Look::materials, scene);
        scene.light["sun"] = new Light;
    }

    void build(const Graph& graph) {
        clear(scene.node);
        clear(scene.model);
        clear(scene.material);
        std::vector<Node*> nodes;
        for (int k = 0; k < graph.nodes; ++k) {
            nodes.push_back(scene.node[k == 0 ? "world" : "node " + std::to_string(k)] = new Node);
        }
        for (std::size_t j = 0; j < graph.childtransforms.size(); ++j) {
            course::connect(nodes.at(std::size_t(graph.edges.at(2 * j))),
                            nodes.at(std::size_t(graph.edges.at(2 * j + 1))),
                            graph.childtransforms[j]);
        }
        for (std::size_t m = 0; m + 4 < graph.materials.size(); m += 5) {
            const glm::vec4* c = &graph.materials[m];
            scene.material[std::to_string(m / 5)] = new Material{c[0], c[1], c[2], c[3], c[4].x};
        }
        for (std::size_t i = 0; i < graph.modeltransforms.size(); ++i) {
            const int* hanging = &graph.hanging.at(3 * i);
            course::hang(nodes.at(std::size_t(hanging[0])), model(hanging[1], hanging[2]),
                         graph.modeltransforms[i]);
        }
        Camera& camera = *scene.camera;
        camera.reset();
        camera.eye = graph.camera.at(0);
        camera.target = graph.camera.at(1);
        camera.up = graph.camera.at(2);
    }

    void draw() {
        course::prepare(scene, 1.0f);
        scene.draw();
    }

    Ints vertexArrays() const {
        Ints names;
        for (const auto& [name, geometry] : scene.geometry) {
            names.push_back(int(geometry->vao));
        }
        return names;
    }

private:
    template <class Pointer>
    static void clear(std::map<std::string, Pointer>& palette) {
        for (auto& [name, pointer] : palette) {
            delete pointer;
        }
        palette.clear();
    }

    // One model for each pair of geometry and material, shared by all nodes that want it.
    Model* model(int geometry, int material) {
        const std::string g = std::to_string(geometry), m = std::to_string(material);
        Model*& found = scene.model[g + " " + m];
        if (found == nullptr) {
            found = new Model{scene.geometry.at(g), scene.material.at(m)};
        }
        return found;
    }

    Scene scene;
};

Stage& stage() {
    static Stage instance;
    return instance;
}

Graph withoutLastEdge(Graph graph) {
    graph.edges.resize(graph.edges.size() - 2);
    graph.childtransforms.pop_back();
    return graph;
}

// What draw() prints of a graph that it should draw. Whether it does so is asked elsewhere.
std::string printedOf(const Graph& graph) {
    stage().build(graph);
    course::PrintWatch watch;
    try {
        stage().draw();
    } catch (...) {
    }
    return watch.text();
}

// One figure for all frames with one look: reading meshes and compiling takes longer than drawing.
template <course::Look look>
Scene& figure() {
    static Scene scene;
    static const bool ready = (course::buildFigure(scene), course::use(look, scene), true);
    (void)ready;
    return scene;
}

void drawScene(const FrameRequest& request, Scene& scene) {
    course::prepare(scene, float(request.width) / float(request.height));
    scene.draw();
}

void drawFigure(const FrameRequest& request, const course::Viewpoint& from) {
    Scene& scene = figure<course::Look::normals>();
    course::look(scene, from);
    drawScene(request, scene);
}

// The window after the right arrow key, eight times, and the up arrow key.
void drawFromTheLeft(const FrameRequest& request) {
    Scene& scene = figure<course::Look::normals>();
    course::look(scene, course::front);
    for (int k = 0; k < 8; ++k) {
        scene.camera->rotateRight(-10.0f);
    }
    scene.camera->rotateUp(-10.0f);
    drawScene(request, scene);
}

course::Viewpoint seededViewpoint(std::uint64_t seed) {
    SeededValues values(seed);
    const float azimuth = values.uniform(2.2f, 4.2f);  // from behind, left or right
    const float height = values.uniform(1.0f, 3.2f), distance = values.uniform(4.2f, 5.4f);
    const glm::vec3 target(values.uniform(-0.2f, 0.3f), 0.8f, values.uniform(-0.2f, 0.3f));
    return {{distance * std::sin(azimuth), height, distance * std::cos(azimuth)}, target};
}

// The student's table, drawn without the student's Scene::draw.
void drawTable(const FrameRequest& request, const glm::vec3& size, float thickness) {
    static Cube cube;
    static NormalShader shader;
    static const bool ready =
        (cube.init(), shader.read_source("shaders/projective.vert", "shaders/normal.frag"),
         shader.compile(), shader.initUniforms(), true);
    (void)ready;
    Scene& lens = figure<course::Look::normals>();
    course::look(lens, course::atTheTable);
    course::prepare(lens, float(request.width) / float(request.height));
    glUseProgram(shader.program);
    shader.projection = lens.camera->proj;
    for (const glm::mat4& piece : course::TableView(size, thickness).pieces) {
        shader.modelview = lens.camera->view * course::upright(piece);
        shader.setUniforms();
        cube.draw();
    }
}

}  // namespace

CG_HARNESS(harness) {
    // The same under several names: what runs out of time is not called again under its name.
    for (const char* name : {"draw", "drawLegs", "drawForward", "drawLeaf", "drawPairs"}) {
        harness.function(
            name, [](int nodes, Ints edges, Matrices childtransforms, Ints hanging,
                     Matrices modeltransforms, Colors materials, Vectors camera, int times) {
                stage().build(
                    {nodes, edges, childtransforms, hanging, modeltransforms, materials, camera});
                for (int k = 0; k < times; ++k) {
                    stage().draw();
                }
                return stage().vertexArrays();
            });
    }
    // A graph whose last edge closes a cycle: whether draw() printed more before it came back than
    // what it prints of the same graph without that edge.
    for (const char* name :
         {"refuseSingleFile", "refuseBranching", "refuseLongWayRound", "refuseItself"}) {
        harness.function(name, [](int nodes, Ints edges, Matrices childtransforms, Ints hanging,
                                  Matrices modeltransforms, Colors materials, Vectors camera) {
            Graph graph{nodes, edges, childtransforms, hanging, modeltransforms, materials, camera};
            const std::string usual = printedOf(withoutLastEdge(graph));
            stage().build(graph);
            course::PrintWatch watch;
            stage().draw();
            return course::saysMore(watch.text(), usual);
        });
    }
    // The figure from some camera, with materials: the vertex arrays of cube, teapot and bunny.
    harness.function("figure", [](glm::vec3 eye, glm::vec3 target, glm::vec3 up) {
        Scene& scene = figure<course::Look::materials>();
        course::look(scene, {eye, target});
        scene.camera->up = up;
        course::prepare(scene, 1.25f);
        scene.draw();
        return Ints{int(scene.geometry["cube"]->vao), int(scene.geometry["teapot"]->vao),
                    int(scene.geometry["bunny"]->vao)};
    });
    // Every piece of the table; every foot, when one hangs in the leg's node; the leg's own model
    // transform; the number of edges from the table to the leg. Where the table cannot be followed,
    // the last of the answer says why.
    harness.function("table", [](glm::vec3 size, float thickness) {
        try {
            const course::TableView view(size, thickness);
            return std::make_tuple(view.pieces, view.feet, view.legPiece, view.legEdges,
                                   course::TableFault{}.numbers());
        } catch (const course::FaultyTable& error) {
            return std::make_tuple(Matrices{}, Matrices{}, glm::mat4(0.0f), 0,
                                   error.fault.numbers());
        }
    });

    harness.frame("figure",
                  [](const FrameRequest& request) { drawFigure(request, course::front); });
    harness.frame("from-the-left", [](const FrameRequest& request) { drawFromTheLeft(request); });
    harness.frame("from-above",
                  [](const FrameRequest& request) { drawFigure(request, course::fromAbove); });
    harness.frame("seeded-view", [](const FrameRequest& request) {
        drawFigure(request, seededViewpoint(request.seed));
    });
    harness.frame("your-table", [](const FrameRequest& request) {
        drawTable(request, {1.7f, 1.1f, 0.9f}, 0.12f);
    });
}
