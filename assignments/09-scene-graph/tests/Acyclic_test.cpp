// The cycle guard of Scene::draw. Each cycle is asked for after the same scene without its last
// edge: whoever draws nothing at all has guarded nothing. Where models are is another task's.
#include <algorithm>
#include <csignal>
#include <map>

#include "graph.h"

using namespace judge;
using namespace truth;

namespace {

const mat4 step = turned(40.0f, {1, 2, 3}) * moved(0.3f, 0.2f, -0.4f);
const mat4 small = scaled(0.2f, 0.2f, 0.2f);

/// A legal scene is not refused: each geometry that hangs somewhere is drawn.
bool expectAccepted(const std::string& what, const Graph& graph, const std::string& function) {
    const auto census = graph.drawn(function);
    for (const Expected& model : graph.expected()) {
        const auto vao = unsigned(census.result.at(std::size_t(model.geometry)));
        const bool drawn = std::any_of(census.draws.begin(), census.draws.end(),
                                       [&](const Draw& draw) { return draw.vertexArray == vao; });
        if (!expectThat(
                what + " has no cycle and is drawn", drawn,
                say("the {} on the path ", geometryNames[model.geometry]) + model.path + " is not"))
            return false;
    }
    return true;
}

/// What became of a scene with a cycle; an empty complaint when it ended in a clear error.
std::string complaintAbout(const protocol::Answer& answer) {
    using protocol::Outcome;
    switch (answer.outcome) {
        case Outcome::exception:
            return "";
        case Outcome::exited:
            return answer.code != 0
                       ? ""
                       : "ended the program with exit status 0, which means that all is well";
        case Outcome::ok:
            return protocol::decode<bool>(protocol::decodeDrawAnswer(answer.payload).value)
                       ? ""
                       : "came back without an error message: throw an exception, or print what "
                         "you do not print of every scene";
        case Outcome::timeout:
            return "never came back: it went round in circles";
        case Outcome::memory:
            return "asked for more and more memory";
        case Outcome::output:
            return "printed without end";
        case Outcome::crash:
            return answer.code == SIGABRT
                       ? ""
                       : say("crashed (signal {}): endless recursion", int(answer.code));
        default:
            throw std::runtime_error(answer.detail);
    }
}

/// A scene that becomes one with a cycle by its last edge.
struct Trap {
    std::string open, closed;  ///< in words, without and with that edge
    Graph graph;
    int from, to;
    const char* function;

    /// Asked once only: a guard that is missing takes its time.
    const protocol::Answer& answer() const {
        static std::map<std::string, protocol::Answer> known;
        const auto [at, isNew] = known.try_emplace(function);
        if (isNew) {
            Graph cyclic = graph;
            cyclic.edge(from, to, step);
            at->second = cyclic.tried(function);
        }
        return at->second;
    }

    /// Whether draw() came to an end by the student's own doing, with an error message or without.
    bool ends() const {
        using protocol::Outcome;
        const auto& todos = answer().todos;
        const Outcome outcome = answer().outcome;
        const bool aborted = outcome == Outcome::crash && answer().code == SIGABRT;
        return (outcome == Outcome::ok || outcome == Outcome::exception ||
                outcome == Outcome::exited || aborted) &&
               std::find(todos.begin(), todos.end(), "acyclic") == todos.end();
    }
};

Trap singleFile() {
    Graph graph;
    const int a = graph.node("a"), b = graph.node("b");
    graph.edge(0, a, step);
    graph.edge(a, b, step);
    graph.hang(b, cube, brass, small);
    return {"the single file world - a - b",
            "the single file world - a - b - a",
            graph,
            b,
            a,
            "refuseSingleFile"};
}

Trap branching() {
    Graph graph;
    const int trunk = graph.node("trunk"), left = graph.node("left"), right = graph.node("right"),
              leaf = graph.node("leaf");
    graph.edge(0, trunk, step);
    graph.edge(trunk, left, step);
    graph.edge(trunk, right, step);
    graph.edge(right, leaf, step);
    graph.edge(left, leaf, step);
    graph.hang(leaf, sphere, jade, small);
    return {"a trunk with two branches that share a leaf",
            "a trunk with a branch that leads back to it",
            graph,
            left,
            trunk,
            "refuseBranching"};
}

Trap longWayRound() {
    Graph graph;
    std::vector<int> ring;
    for (int k = 0; k < 7; ++k)
        ring.push_back(graph.node(say("stop {}", k)));
    const int pole = graph.node("pole");
    graph.edge(0, pole, step);
    graph.hang(pole, torus, brass, small);
    graph.edge(0, ring[0], step);
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
        graph.edge(ring[k], pole, step);
        graph.edge(ring[k], ring[k + 1], step);
    }
    graph.hang(ring.back(), cube, jade, small);
    return {"a row of seven stops, each with a pole",
            "seven stops of which the last leads back to the second",
            graph,
            ring.back(),
            ring[1],
            "refuseLongWayRound"};
}

Trap itself() {
    Graph graph;
    const int arm = graph.node("arm"), hand = graph.node("hand");
    graph.edge(0, arm, step);
    graph.edge(arm, hand, step);
    graph.hang(hand, torus, jade, small);
    return {"an arm with a hand", "an arm with a hand that is its own child", graph, hand, hand,
            "refuseItself"};
}

/// Without the cycle the scene is drawn, with it it is refused.
void expectGuarded(const Trap& trap) {
    if (!expectAccepted(trap.open, trap.graph, "draw"))
        return;
    if (const std::string complaint = complaintAbout(trap.answer()); !complaint.empty())
        fail("draw() of " + trap.closed + " " + complaint);
}

/// To let everything pass is no guard: a legal scene counts where some cycle comes to an end.
void expectLegal(const std::string& what, const Graph& graph, const std::string& function) {
    if (!expectAccepted(what, graph, function))
        return;
    for (const Trap& trap : {branching(), singleFile(), longWayRound()}) {
        if (trap.ends())
            return;
    }
    fail(what + " is drawn, which counts once some cycle comes to an end: none of three did");
}

}  // namespace

TEST(Acyclic, SingleFile) {
    check(
        "world - a - b - a is refused, though nothing ever piles up on a stack",
        "With one child each, the stack of nodes never holds more than one: look at the path from "
        "the world, or at how deep it is, not at the size of the stack.");
    expectGuarded(singleFile());
}

TEST(Acyclic, Branching) {
    check("a cycle is refused, too, where nodes have several children");
    expectGuarded(branching());
}

TEST(Acyclic, Itself) {
    check("a node that is its own child is refused");
    expectGuarded(itself());
}

TEST(Acyclic, LongWayRound) {
    check("a cycle is refused, too, when it is long and the scene has other branches");
    expectGuarded(longWayRound());
}

TEST(Acyclic, TenLegs) {
    check("ten edges to one leg are no cycle",
          "Ten legs wait on the stack at once, with two nodes below the world: the tip of section "
          "9.2.3 is wrong here.");
    Graph graph;
    const int table = graph.node("table"), leg = graph.node("leg");
    graph.edge(0, table, step);
    for (int k = 0; k < 10; ++k)
        graph.edge(table, leg, moved(0.1f * float(k), 0.0f, 0.0f));
    graph.hang(leg, cube, brass, small);
    expectLegal("a table with ten legs", graph, "drawLegs");
}

TEST(Acyclic, EveryForwardEdge) {
    check("five nodes with an edge from each to every later one are no cycle",
          "There are ten edges and a stack of seven entries, none of them on one path twice.");
    // Which end of the list of children fills a stack most depends on who pushes them.
    for (const bool reversed : {false, true}) {
        Graph graph;
        for (const char* name : {"one", "two", "three", "four"})
            graph.node(name);
        for (int from = 0; from < graph.size(); ++from) {
            for (int k = from + 1; k < graph.size(); ++k)
                graph.edge(from, reversed ? graph.size() + from - k : k, step);
        }
        graph.hang(2, sphere, ruby, small);
        graph.hang(4, cube, brass, small);
        expectLegal("a scene of five nodes with every forward edge", graph, "drawForward");
    }
}

TEST(Acyclic, ManyPaths) {
    check("nine pairs of edges in a row are no cycle, though 512 paths lead through them",
          "No fixed number of steps is too many for a legal scene. What cannot grow is one path: "
          "without a cycle it has fewer edges than there are nodes.");
    Graph graph;
    const int beside = graph.node("beside");
    graph.edge(0, beside, step);
    graph.hang(beside, cube, brass, small);
    int last = 0;
    for (int k = 0; k < 9; ++k) {
        const int next = graph.node(say("pair {}", k));
        graph.edge(last, next, step);
        graph.edge(last, next, small);
        last = next;
    }
    expectLegal("a scene with nine pairs of edges in a row", graph, "drawPairs");
}

TEST(Acyclic, NoChildren) {
    check("a world without children is no cycle",
          "It has no edge at all and one entry on the stack: do not compare these two.");
    Graph withChild;
    const int child = withChild.node("child");
    withChild.edge(0, child, step);
    withChild.hang(child, cube, brass, small);
    Graph alone;
    alone.hang(0, torus, jade, small);
    if (expectAccepted("a world with one child", withChild, "draw"))
        expectLegal("a world with one model and no children", alone, "drawLeaf");
}
