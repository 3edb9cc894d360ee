// Scene::draw (algorithm 9.3), judged by its draw calls. Transforms turn and move, so that none of
// them commute, and the camera stands anywhere.
#include "drawn.h"

using namespace judge;
using namespace truth;

namespace {

const mat4 A = turned(35.0f, {1, 2, 3}) * moved(0.5f, -0.3f, 0.8f);
const mat4 B = moved(-0.7f, 0.4f, 0.2f) * turned(-70.0f, {3, -1, 2});
const mat4 C = turned(110.0f, {-1, 1, 4}) * moved(0.1f, 0.9f, -0.6f);
const mat4 D = moved(0.3f, 0.2f, 1.1f) * turned(50.0f, {2, 5, -1}) * scaled(0.9f, 1.2f, 0.7f);
const mat4 M = moved(0.2f, -0.5f, 0.3f) * turned(25.0f, {1, -2, 1}) * scaled(0.5f, 0.3f, 0.8f);
const mat4 N = turned(-40.0f, {0, 3, 1}) * moved(0.6f, 0.1f, -0.2f) * scaled(0.4f, 0.6f, 0.5f);

/// world - shoulder - elbow - hand, one model on each.
Graph arm() {
    Graph graph;
    const int shoulder = graph.node("shoulder"), elbow = graph.node("elbow"),
              hand = graph.node("hand");
    graph.edge(0, shoulder, A);
    graph.edge(shoulder, elbow, B);
    graph.edge(elbow, hand, C);
    graph.hang(shoulder, sphere, brass, M);
    graph.hang(elbow, cube, jade, N);
    graph.hang(hand, torus, ruby, D);
    return graph;
}

}  // namespace

TEST(Draw, Figure) {
    check("of figure 9.1 nine models are drawn: six cubes, two teapots, one bunny",
          "The table leg is reached by four paths, and is drawn for each of them.");
    const auto census = subject().census<std::vector<int>>("figure", vec3(1.6f, 2.1f, 5.0f),
                                                           vec3(0, 0.95f, 0), vec3(0, 1, 0));
    std::vector<std::vector<Draw>> of(3);
    needCount("figure", census.result.size(), of.size());
    for (const Draw& draw : census.draws) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (draw.vertexArray == unsigned(census.result.at(k)))
                of[k].push_back(draw);
        }
    }
    const std::string found =
        say("found draws: {} (cubes: {}, teapots: {}, bunnies: {})", int(census.draws.size()),
            int(of[0].size()), int(of[1].size()), int(of[2].size()));
    if (expectThat(
            "nine models",
            of[0].size() == 6 && of[1].size() == 2 && of[2].size() == 1 && census.draws.size() == 9,
            found))
        expectThat("the two teapots have different materials",
                   difference(of[1][0].diffuse, of[1][1].diffuse) > 0.1f,
                   say("both have diffuse {}", of[1][0].diffuse));
}

TEST(Draw, ThreeLevels) {
    check("transforms are multiplied along the path, the parent's on the left",
          "modelview = view * T(world, 0) * ... * M, as in (9.2): a child's matrix comes after its "
          "parent's.");
    expectGraph(arm());
}

TEST(Draw, UnderTheWorld) {
    check("models that hang directly in the world are drawn, too");
    Graph graph = arm();
    graph.hang(0, cube, lamp, M);
    graph.hang(0, torus, brass, D);
    expectGraph(graph);
}

TEST(Draw, Siblings) {
    check("children of one node do not inherit from each other",
          "Each child starts from its parent's matrix, not from the last one that was used.");
    Graph graph;
    const int body = graph.node("body"), left = graph.node("left"), right = graph.node("right"),
              thumb = graph.node("thumb");
    graph.edge(0, body, A);
    graph.edge(body, left, B);
    graph.edge(body, right, C);
    graph.edge(left, thumb, D);
    graph.hang(left, cube, brass, M);
    graph.hang(right, cube, jade, N);
    graph.hang(thumb, cube, ruby, M);
    graph.hang(body, sphere, lamp, N);
    expectGraph(graph);
}

TEST(Draw, SharedChild) {
    check("a node that two parents share is drawn once for each of them",
          "Do not mark nodes as visited: every path counts (note 9.1).");
    Graph graph;
    const int left = graph.node("left"), right = graph.node("right"), shared = graph.node("shared");
    graph.edge(0, left, A);
    graph.edge(0, right, B);
    graph.edge(left, shared, C);
    graph.edge(right, shared, D);
    graph.hang(shared, torus, jade, M);
    graph.hang(left, cube, brass, N);
    expectGraph(graph);
}

TEST(Draw, RepeatedEdges) {
    check(
        "three edges from one node to the same child draw it three times, each with its transform",
        "childtransforms[j] belongs to childnodes[j], even when the same child comes again.");
    Graph graph;
    const int stool = graph.node("stool"), leg = graph.node("leg"), foot = graph.node("foot");
    graph.edge(0, stool, A);
    for (const mat4& transform : {B, C, D})
        graph.edge(stool, leg, transform);
    graph.edge(leg, foot, N);
    graph.hang(leg, cube, brass, M);
    graph.hang(foot, sphere, ruby, N);
    expectGraph(graph);
}

TEST(Draw, ManyModels) {
    check(
        "several models of one node are drawn, each with its own transform",
        "modeltransforms[i] belongs to models[i]. No transform passes from one model to the next.");
    Graph graph;
    const int shelf = graph.node("shelf");
    graph.edge(0, shelf, A);
    graph.hang(shelf, cube, brass, M);
    graph.hang(shelf, cube, brass, N);
    graph.hang(shelf, torus, brass, B);
    graph.hang(shelf, cube, brass, C);
    expectGraph(graph);
}

TEST(Draw, Materials) {
    check("each model is drawn with its own material, whatever was drawn before",
          "Set modelview and material, call shader->setUniforms(), and draw only then.");
    for (const bool reversed : {false, true}) {
        Graph graph;
        const int shelf = graph.node("shelf"), below = graph.node("below");
        graph.edge(0, shelf, A);
        graph.edge(shelf, below, B);
        for (const int material :
             reversed ? std::vector{lamp, ruby, jade, brass} : std::vector{brass, jade, ruby, lamp})
            graph.hang(shelf, cube, material, moved(0.2f * float(material), 0.1f, 0.0f) * M);
        graph.hang(below, cube, reversed ? brass : lamp, N);
        if (!expectGraph(graph))
            return;
    }
}

TEST(Draw, EmptyNodes) {
    check("nodes without models and nodes without children are passed over",
          "Compare i < models.size(): size() - 1 of an empty list is a huge number, not -1.");
    Graph graph;
    const int twig = graph.node("twig"), fork = graph.node("fork"), leaf = graph.node("leaf"),
              stump = graph.node("stump");
    graph.edge(0, twig, A);
    graph.edge(twig, fork, B);
    graph.edge(fork, leaf, C);
    graph.edge(fork, stump, D);
    graph.hang(leaf, sphere, jade, M);
    expectGraph(graph);
}

TEST(Draw, EmptyWorld) {
    check("a world that holds nothing but an empty node draws nothing, after one that held more");
    Graph empty;
    empty.edge(0, empty.node("empty"), A);
    if (expectGraph(arm()))
        expectGraph(empty);
}

TEST(Draw, Chain) {
    check(
        "a chain of 500 nodes, each turned a little against the one above, is followed to its end");
    Graph graph;
    const mat4 link = turned(3.0f, {1, 2, -1}) * moved(0.02f, -0.01f, 0.03f);
    int last = 0;
    for (int k = 1; k <= 500; ++k) {
        const int next = graph.node(say("link {}", k));
        graph.edge(last, next, link);
        if (k % 100 == 0)
            graph.hang(next, cube, k / 100 % 4, M);
        last = next;
    }
    expectGraph(graph, 1e-3f);
}

TEST(Draw, Camera) {
    check("the view matrix of the camera is the first factor, once",
          "Start from camera->view; it is there when draw() is called.");
    Graph graph = arm();
    for (const truth::Camera& camera :
         {truth::Camera{{-3.0f, 0.6f, 1.0f}, {0.2f, 0.5f, -0.6f}, {0.1f, 1.0f, 0.3f}},
          truth::Camera{{0.7f, -4.1f, -6.0f}, {-0.5f, 0.3f, 0.2f}, {-0.3f, 0.8f, 0.1f}}}) {
        graph.camera = camera;
        if (!expectGraph(graph))
            return;
    }
}

TEST(Draw, TwiceIsTwice) {
    check("a second picture of the same scene is the same as the first",
          "Start each draw() with fresh stacks, and change nothing in the graph.");
    expectGraph(arm(), tolerance, 2);
}
