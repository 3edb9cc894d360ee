#include "Torus.h"

#include <cg/Error.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

void Torus::init() {
    if (!(tube > 0.0f && tube < 1.0f) || rings < 3 || sides < 3) {
        throw cg::Error(
            "Torus: expected a tube between 0 and 1 and at least 3 rings and sides, found " +
            std::to_string(tube) + ", " + std::to_string(rings) + " and " + std::to_string(sides));
    }
    std::vector<GLfloat> positions, normals;
    std::vector<GLuint> indices;
    const auto vertex = [this](int r, int s) { return GLuint((r % rings) * sides + s % sides); };
    for (int r = 0; r < rings; ++r) {
        const float round = glm::two_pi<float>() * float(r) / float(rings);
        const glm::vec3 outwards(std::sin(round), 0.0f, std::cos(round));
        for (int s = 0; s < sides; ++s) {
            const float turn = glm::two_pi<float>() * float(s) / float(sides);
            const glm::vec3 n = std::cos(turn) * outwards + glm::vec3(0.0f, std::sin(turn), 0.0f);
            const glm::vec3 p = outwards + tube * n;
            positions.insert(positions.end(), {p.x, p.y, p.z});
            normals.insert(normals.end(), {n.x, n.y, n.z});
            indices.insert(indices.end(), {vertex(r, s), vertex(r + 1, s), vertex(r + 1, s + 1),
                                           vertex(r, s), vertex(r + 1, s + 1), vertex(r, s + 1)});
        }
    }
    build({{3, positions}, {3, normals}}, indices);
}
