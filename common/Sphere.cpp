#include "Sphere.h"

#include <cg/Error.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

void Sphere::init() {
    if (slices < 3 || stacks < 2) {
        throw cg::Error("Sphere: expected at least 3 slices and 2 stacks, found " +
                        std::to_string(slices) + " and " + std::to_string(stacks));
    }
    std::vector<GLfloat> positions = {0.0f, 1.0f, 0.0f};  // vertex 0: the north pole
    for (int stack = 1; stack < stacks; ++stack) {
        const float polar = glm::pi<float>() * float(stack) / float(stacks);
        for (int slice = 0; slice < slices; ++slice) {
            const float azimuth = glm::two_pi<float>() * float(slice) / float(slices);
            positions.insert(positions.end(), {std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                               std::sin(polar) * std::cos(azimuth)});
        }
    }
    positions.insert(positions.end(), {0.0f, -1.0f, 0.0f});

    // Ring r = 1 ... stacks - 1, counted from the north pole; slice s goes round to the right.
    const auto vertex = [this](int r, int s) { return GLuint(1 + (r - 1) * slices + s % slices); };
    const auto southPole = GLuint(positions.size() / 3 - 1);
    std::vector<GLuint> indices;
    for (int s = 0; s < slices; ++s) {
        indices.insert(indices.end(), {0u, vertex(1, s), vertex(1, s + 1)});
        for (int r = 1; r + 1 < stacks; ++r) {
            indices.insert(indices.end(), {vertex(r, s), vertex(r + 1, s), vertex(r + 1, s + 1),
                                           vertex(r, s), vertex(r + 1, s + 1), vertex(r, s + 1)});
        }
        indices.insert(indices.end(),
                       {vertex(stacks - 1, s), southPole, vertex(stacks - 1, s + 1)});
    }
    build({{3, positions}, {3, positions}}, indices);  // radius 1: the normal is the position
}
