#include "drawn.h"

using namespace judge;
using namespace truth;

namespace {

mat4 drawnTransform() {
    Random& values = judge::random();
    const vec3 away = values.uniform(0.2f, 1.0f) * values.unitVector();
    return turned(values.angle(), values.unitVector()) * moved(away.x, away.y, away.z) *
           scaled(values.uniform(0.6f, 1.3f), values.uniform(0.6f, 1.3f),
                  values.uniform(0.6f, 1.3f));
}

}  // namespace

TEST(Draw, DrawnGraph) {
    check("a scene with transforms and a camera drawn from the seed is right");
    Graph graph;
    const vec3 target = judge::random().unitVector();
    graph.camera = {target + 4.0f * judge::random().unitVector(), target,
                    judge::random().unitVector()};
    // Three layers of two nodes; each node is a child of both nodes of the layer above.
    std::vector<int> above = {0};
    for (int layer = 0; layer < 3; ++layer) {
        const std::vector<int> nodes = {graph.node(say("layer {} left", layer)),
                                        graph.node(say("layer {} right", layer))};
        for (const int parent : above) {
            for (const int child : nodes)
                graph.edge(parent, child, drawnTransform());
        }
        graph.hang(nodes[0], layer, layer, drawnTransform());
        graph.hang(nodes[1], 2 - layer, layer + 1, drawnTransform());
        above = nodes;
    }
    expectGraph(graph);
}
