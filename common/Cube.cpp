#include "Cube.h"

#include <glm/glm.hpp>

namespace {

/// Outward normal of a face and the direction that is "right" to someone who looks at it.
struct Face {
    glm::vec3 normal;
    glm::vec3 right;
};

const Face faces[] = {
    {{0, 0, 1}, {1, 0, 0}},    // front
    {{0, 0, -1}, {-1, 0, 0}},  // back
    {{-1, 0, 0}, {0, 0, 1}},   // left
    {{1, 0, 0}, {0, 0, -1}},   // right
    {{0, 1, 0}, {1, 0, 0}},    // top
    {{0, -1, 0}, {1, 0, 0}},   // bottom
};

}  // namespace

void Cube::init() {
    std::vector<GLfloat> positions;
    std::vector<GLfloat> normals;
    std::vector<GLuint> indices;
    for (const Face& face : faces) {
        const auto first = static_cast<GLuint>(positions.size() / 3);
        const glm::vec3 up = glm::cross(face.normal, face.right);
        // Corners counter-clockwise from the lower left one.
        for (const glm::vec2& corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
            const glm::vec3& n = face.normal;
            const glm::vec3 p = 0.5f * (n + corner.x * face.right + corner.y * up);
            positions.insert(positions.end(), {p.x, p.y, p.z});
            normals.insert(normals.end(), {n.x, n.y, n.z});
        }
        for (const GLuint offset : {0u, 1u, 2u, 0u, 2u, 3u}) {
            indices.push_back(first + offset);
        }
    }
    build({{3, positions}, {3, normals}}, indices);
}
