// Compares what Scene::draw drew with what it has to draw, in whatever order.
#pragma once

#include <algorithm>

#include "graph.h"

namespace truth {

constexpr float tolerance = 1e-4f;

template <class T>
float difference(const T& got, const T& expected) {
    const float most = judge::detail::largest(T(got - expected));
    return most / std::max(1.0f, judge::detail::largest(expected));  // NaN stays NaN
}

inline bool wears(const judge::Draw& draw, const Material& material) {
    return difference(draw.ambient, material.ambient) <= tolerance &&
           difference(draw.diffuse, material.diffuse) <= tolerance &&
           difference(draw.specular, material.specular) <= tolerance &&
           difference(draw.emision, material.emision) <= tolerance &&
           difference(draw.shininess, material.shininess) <= tolerance;
}

inline std::string tell(const Expected& model) {
    return judge::say("the {} of {} on the path ", geometryNames[model.geometry],
                      palette[std::size_t(model.material)].name) +
           model.path;
}

/// Why no draw call is the one that is expected.
inline std::string explain(const Expected& model, const std::vector<judge::Draw>& sameGeometry,
                           float allowed) {
    if (sameGeometry.empty())
        return tell(model) + " is not drawn";
    const judge::Draw* nearest = &sameGeometry.front();
    for (const judge::Draw& draw : sameGeometry) {
        if (difference(draw.modelview, model.modelview) <
            difference(nearest->modelview, model.modelview))
            nearest = &draw;
    }
    if (difference(nearest->modelview, model.modelview) <= allowed)
        return tell(model) + judge::say(
                                 " is drawn with another material: diffuse {} instead of {}, "
                                 "shininess {} instead of {}",
                                 nearest->diffuse, palette[std::size_t(model.material)].diffuse,
                                 nearest->shininess,
                                 palette[std::size_t(model.material)].shininess);
    return tell(model) + judge::say(
                             " is not drawn where it belongs: its modelview is {}, the nearest "
                             "that you drew is {}",
                             model.modelview, nearest->modelview);
}

/// Every expected model has one draw call, and no draw call is left. Returns success.
inline bool expectDraws(const std::vector<Expected>& expected,
                        const judge::Census<std::vector<int>>& census, float allowed = tolerance) {
    std::vector<judge::Draw> left = census.draws;
    const std::string count = judge::say(
        "models drawn: {}, expected {}: ", int(census.draws.size()), int(expected.size()));
    for (const Expected& model : expected) {
        const auto vao = unsigned(census.result.at(std::size_t(model.geometry)));
        const auto found = std::find_if(left.begin(), left.end(), [&](const judge::Draw& draw) {
            return draw.vertexArray == vao && wears(draw, palette[std::size_t(model.material)]) &&
                   difference(draw.modelview, model.modelview) <= allowed;
        });
        if (found != left.end()) {
            left.erase(found);
            continue;
        }
        std::vector<judge::Draw> candidates;
        for (const judge::Draw& draw : left) {
            if (draw.vertexArray == vao)
                candidates.push_back(draw);
        }
        const bool sameCount = census.draws.size() == expected.size();
        judge::fail((sameCount ? "" : count) + explain(model, candidates, allowed));
        return false;
    }
    return judge::expectThat("draw calls", left.empty(), count + "one of them is drawn too often");
}

/// Draws a graph and compares. Every such graph is one that a guard by the size of the stack lets
/// pass: has at least one edge, and neither more entries than nodes nor than edges.
inline bool expectGraph(const Graph& graph, float allowed = tolerance, int times = 1) {
    if (graph.largestStack() > std::size_t(std::min(graph.size(), graph.edges())))
        throw std::logic_error("this graph belongs to the task acyclic");
    std::vector<Expected> expected;
    for (int k = 0; k < times; ++k) {
        const std::vector<Expected> once = graph.expected();
        expected.insert(expected.end(), once.begin(), once.end());
    }
    return expectDraws(expected, graph.drawn("draw", times), allowed);
}

}  // namespace truth
