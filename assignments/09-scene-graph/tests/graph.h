// Scene graphs for Scene::draw, and what has to be drawn, computed in the judge.
#pragma once

#include <subject/Judge.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

namespace truth {

using glm::mat4;
using glm::vec3;
using glm::vec4;

inline mat4 moved(float x, float y, float z) {
    return glm::translate(mat4(1.0f), vec3(x, y, z));
}
inline mat4 turned(float degrees, const vec3& axis) {
    return glm::rotate(mat4(1.0f), glm::radians(degrees), glm::normalize(axis));
}
inline mat4 scaled(float x, float y, float z) {
    return glm::scale(mat4(1.0f), vec3(x, y, z));
}

/// The geometries that the harness has.
enum Geometry { cube, torus, sphere };
inline const char* const geometryNames[] = {"cube", "torus", "sphere"};

struct Material {
    std::string name;
    vec4 ambient, diffuse, specular, emision;
    float shininess;
};
/// No two agree in any member.
inline const std::vector<Material> palette = {
    {"brass",
     {.33f, .22f, .03f, 1},
     {.78f, .57f, .11f, 1},
     {.99f, .94f, .81f, 1},
     {.01f, 0, 0, 1},
     27.5f},
    {"jade",
     {.13f, .24f, .16f, 1},
     {.54f, .89f, .63f, 1},
     {.31f, .32f, .33f, 1},
     {0, .02f, 0, 1},
     12.5f},
    {"ruby",
     {.17f, .01f, .02f, 1},
     {.61f, .04f, .05f, 1},
     {.73f, .62f, .63f, 1},
     {0, 0, .03f, 1},
     76.5f},
    {"lamp",
     {.05f, .05f, .04f, 1},
     {.02f, .03f, .01f, 1},
     {.06f, .07f, .08f, 1},
     {1, .9f, .7f, 1},
     3.5f},
};
enum { brass, jade, ruby, lamp };

struct Camera {
    vec3 eye, target, up;
};
inline const Camera someCamera{{2.0f, 1.5f, 4.0f}, {0.4f, -0.3f, 0.7f}, {0.2f, 1.0f, -0.3f}};

struct Expected {
    std::string path;  ///< "world - arm - hand"
    int geometry, material;
    mat4 modelview;
};

class Graph {
public:
    Camera camera = someCamera;

    Graph() { node("world"); }

    /// Adds a node that nothing leads to yet; its number.
    int node(const std::string& name) {
        names_.push_back(name);
        return int(names_.size()) - 1;
    }
    void edge(int parent, int child, const mat4& transform) {
        edges_.insert(edges_.end(), {parent, child});
        childtransforms_.push_back(transform);
    }
    void hang(int node, int geometry, int material, const mat4& transform) {
        hanging_.insert(hanging_.end(), {node, geometry, material});
        modeltransforms_.push_back(transform);
    }

    /// What a right Scene::draw draws, in some order. The graph must be acyclic.
    std::vector<Expected> expected() const {
        std::vector<Expected> found;
        follow(0, glm::dmat4(glm::lookAt(camera.eye, camera.target, camera.up)), names_[0], found);
        return found;
    }

    judge::Census<std::vector<int>> drawn(const std::string& function = "draw",
                                          int times = 1) const {
        auto census = judge::subject().census<std::vector<int>>(
            function, int(names_.size()), edges_, childtransforms_, hanging_, modeltransforms_,
            colors(), view(), times);
        judge::needCount(function, census.result.size(), std::size(geometryNames));
        return census;
    }

    /// Draws a graph with a cycle, where no other scene is drawn afterwards.
    protocol::Answer tried(const std::string& function) const {
        return judge::subject().tryAlone(function, int(names_.size()), edges_, childtransforms_,
                                         hanging_, modeltransforms_, colors(), view());
    }

    int size() const { return int(names_.size()); }
    int edges() const { return int(childtransforms_.size()); }

    /// Most entries that a stack has which holds the nodes still to be visited, whichever end of
    /// the list of children is pushed first.
    std::size_t largestStack() const { return std::max(largestStack(false), largestStack(true)); }

private:
    void follow(int node, const glm::dmat4& matrix, const std::string& path,
                std::vector<Expected>& found) const {
        for (std::size_t i = 0; i < modeltransforms_.size(); ++i) {
            if (hanging_[3 * i] == node)
                found.push_back({path, hanging_[3 * i + 1], hanging_[3 * i + 2],
                                 mat4(matrix * glm::dmat4(modeltransforms_[i]))});
        }
        for (std::size_t j = 0; j < childtransforms_.size(); ++j) {
            const int child = edges_[2 * j + 1];
            if (edges_[2 * j] == node)
                follow(child, matrix * glm::dmat4(childtransforms_[j]), below(path, child), found);
        }
    }
    /// A long path is told by its ends.
    std::string below(const std::string& path, int child) const {
        const std::string& name = names_[std::size_t(child)];
        const std::string longer = " - ... - ";
        if (path.size() < 60)
            return path + " - " + name;
        return path.substr(0, path.find(" - ")) + longer + name;
    }

    std::size_t largestStack(bool reversed) const {
        std::vector<int> stack = {0};
        std::size_t most = 1;
        while (!stack.empty()) {
            const int node = stack.back();
            stack.pop_back();
            std::vector<int> children;
            for (std::size_t j = 0; j < childtransforms_.size(); ++j) {
                if (edges_[2 * j] == node)
                    children.push_back(edges_[2 * j + 1]);
            }
            if (reversed)
                std::reverse(children.begin(), children.end());
            stack.insert(stack.end(), children.begin(), children.end());
            most = std::max(most, stack.size());
        }
        return most;
    }

    static std::vector<vec4> colors() {
        std::vector<vec4> flat;
        for (const Material& each : palette)
            flat.insert(flat.end(), {each.ambient, each.diffuse, each.specular, each.emision,
                                     vec4(each.shininess, 0, 0, 0)});
        return flat;
    }
    std::vector<vec3> view() const { return {camera.eye, camera.target, camera.up}; }

    std::vector<std::string> names_;
    std::vector<int> edges_, hanging_;
    std::vector<mat4> childtransforms_, modeltransforms_;
};

}  // namespace truth
