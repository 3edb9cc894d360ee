#pragma once

#include <Geometry.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace cg {

/// For tests: what a geometry with positions and normals has in its buffers.
struct ReadBack {
    std::vector<glm::vec3> positions, normals;
    std::vector<GLuint> indices;

    explicit ReadBack(const Geometry& geometry)
        : positions(contents<glm::vec3>(GL_ARRAY_BUFFER, geometry.buffers.at(0))),
          normals(contents<glm::vec3>(GL_ARRAY_BUFFER, geometry.buffers.at(1))),
          indices(contents<GLuint>(GL_ELEMENT_ARRAY_BUFFER, geometry.buffers.at(2))) {}

    /// Twice the area of triangle k, along its counter-clockwise normal.
    glm::vec3 cross(std::size_t k) const {
        const glm::vec3 a = positions.at(indices.at(3 * k));
        return glm::cross(positions.at(indices.at(3 * k + 1)) - a,
                          positions.at(indices.at(3 * k + 2)) - a);
    }

    /// Whether every edge is shared by two triangles that run along it in opposite directions.
    bool isClosed() const {
        std::map<std::pair<GLuint, GLuint>, int> edges;
        for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
            for (std::size_t i = 0; i < 3; ++i) {
                ++edges[{indices[k + i], indices[k + (i + 1) % 3]}];
            }
        }
        for (const auto& [edge, times] : edges) {
            if (times != 1 || edges.count({edge.second, edge.first}) == 0) {
                return false;
            }
        }
        return true;
    }

private:
    template <class Value>
    static std::vector<Value> contents(GLenum target, GLuint buffer) {
        GLint bytes = 0;
        glBindVertexArray(0);
        glBindBuffer(target, buffer);
        glGetBufferParameteriv(target, GL_BUFFER_SIZE, &bytes);
        std::vector<Value> values(static_cast<std::size_t>(bytes) / sizeof(Value));
        glGetBufferSubData(target, 0, bytes, values.data());
        glBindBuffer(target, 0);
        return values;
    }
};

}  // namespace cg
