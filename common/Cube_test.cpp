#include "Cube.h"

#include <cg/GlTest.h>

#include <glm/glm.hpp>

#include <set>

namespace {

using CubeTest = cg::GlTest;

template <class Value>
std::vector<Value> contents(GLenum target, GLuint buffer) {
    GLint bytes = 0;
    glBindBuffer(target, buffer);
    glGetBufferParameteriv(target, GL_BUFFER_SIZE, &bytes);
    std::vector<Value> values(static_cast<std::size_t>(bytes) / sizeof(Value));
    glGetBufferSubData(target, 0, bytes, values.data());
    glBindBuffer(target, 0);
    return values;
}

struct Mesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<GLuint> indices;
};

Mesh readBack(const Geometry& geometry) {
    glBindVertexArray(0);
    return {contents<glm::vec3>(GL_ARRAY_BUFFER, geometry.buffers.at(0)),
            contents<glm::vec3>(GL_ARRAY_BUFFER, geometry.buffers.at(1)),
            contents<GLuint>(GL_ELEMENT_ARRAY_BUFFER, geometry.buffers.at(2))};
}

TEST_F(CubeTest, HasTwentyFourVerticesOnItsCorners) {
    Cube cube;
    cube.init();
    const Mesh mesh = readBack(cube);
    ASSERT_EQ(mesh.positions.size(), 24u);
    ASSERT_EQ(mesh.normals.size(), 24u);
    EXPECT_EQ(cube.count, 36);
    EXPECT_EQ(mesh.indices.size(), 36u);
    std::set<std::tuple<float, float, float>> corners;
    for (std::size_t k = 0; k < 24; ++k) {
        const glm::vec3 p = mesh.positions[k];
        EXPECT_EQ(glm::abs(p), glm::vec3(0.5f));
        EXPECT_FLOAT_EQ(glm::dot(p, mesh.normals[k]), 0.5f) << "vertex " << k;
        EXPECT_FLOAT_EQ(glm::length(mesh.normals[k]), 1.0f);
        corners.insert({p.x, p.y, p.z});
    }
    EXPECT_EQ(corners.size(), 8u);
}

TEST_F(CubeTest, TrianglesAreCounterClockwiseFromOutsideAndCoverEveryFace) {
    Cube cube;
    cube.init();
    const Mesh mesh = readBack(cube);
    float area = 0;
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
        const glm::vec3 a = mesh.positions.at(mesh.indices[k]);
        const glm::vec3 b = mesh.positions.at(mesh.indices[k + 1]);
        const glm::vec3 c = mesh.positions.at(mesh.indices[k + 2]);
        const glm::vec3 cross = glm::cross(b - a, c - a);
        EXPECT_FLOAT_EQ(glm::length(cross), 1.0f) << "triangle " << k / 3;  // half a unit square
        EXPECT_FLOAT_EQ(glm::dot(cross, mesh.normals.at(mesh.indices[k])), 1.0f)
            << "triangle " << k / 3;
        area += glm::length(cross) / 2;
    }
    EXPECT_FLOAT_EQ(area, 6.0f);
}

}  // namespace
