#include "Geometry.h"

#include "Cube.h"

#include <cg/Error.h>
#include <cg/GlTest.h>
#include <cg/Ownership.h>

#include <algorithm>
#include <optional>

namespace {

class GeometryTest : public cg::GlTest {};

/// The names of everything that a cube made.
struct Names {
    explicit Names(const Geometry& geometry) : vao(geometry.vao), buffers(geometry.buffers) {}

    int alive() const {
        int count = glIsVertexArray(vao);
        for (const GLuint buffer : buffers) {
            count += glIsBuffer(buffer);
        }
        return count;
    }

    GLuint vao;
    std::vector<GLuint> buffers;
};

TEST_F(GeometryTest, DeletesItsObjects) {
    std::optional<Cube> cube(std::in_place);
    cube->init();
    const Names names(*cube);
    EXPECT_EQ(names.alive(), 4);
    cube.reset();
    EXPECT_EQ(names.alive(), 0);
}

TEST_F(GeometryTest, InitTwiceDeletesTheFirstObjects) {
    Cube cube;
    cube.init();
    const Names first(cube);
    std::vector<GLuint> reserve(8);  // keeps GL from handing out the freed names again
    glGenBuffers(8, reserve.data());
    cube.init();
    const Names second(cube);
    EXPECT_EQ(second.alive(), 4);
    int stillThere = 0;
    for (const GLuint buffer : first.buffers) {
        const bool reused =
            std::find(second.buffers.begin(), second.buffers.end(), buffer) != second.buffers.end();
        stillThere += !reused && glIsBuffer(buffer);
    }
    EXPECT_EQ(stillThere, 0);
    glDeleteBuffers(8, reserve.data());
}

TEST_F(GeometryTest, DeletesWhatADerivedClassMadeByItself) {
    struct Own : Geometry {
        using Geometry::init;
        void init() override {
            glGenVertexArrays(1, &vao);
            buffers.resize(1);
            glGenBuffers(1, buffers.data());
            glBindVertexArray(vao);
            glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
            glBindVertexArray(0);
        }
    };
    std::optional<Own> own(std::in_place);
    own->init();
    const Names names(*own);
    EXPECT_EQ(names.alive(), 2);
    own.reset();
    EXPECT_EQ(names.alive(), 0);
}

TEST_F(GeometryTest, NeedsAContext) {
    context.reset();
    Cube cube;
    EXPECT_NE(cg::messageOf<cg::Error>([&] { cube.init(); }).find("current OpenGL context"),
              std::string::npos);
}

TEST_F(GeometryTest, DestroyedAfterItsContextLeavesTheNextOneAlone) {
    std::optional<Cube> old(std::in_place);
    old->init();
    context.reset();
    context = cg::createOsMesaContext(64, 48);
    Cube cube;
    cube.init();
    const Names names(cube);
    EXPECT_EQ(old->vao, cube.vao) << "the test wants equal names in both contexts";
    old.reset();
    EXPECT_EQ(names.alive(), 4);
}

TEST_F(GeometryTest, WithoutAnyContextNothingMayBeDeleted) {
    std::optional<Cube> cube(std::in_place);
    cube->init();
    const unsigned madeIn = cg::currentContextId();
    EXPECT_TRUE(cg::mayDelete(madeIn));
    context.reset();
    EXPECT_FALSE(cg::mayDelete(madeIn));
    EXPECT_FALSE(cg::mayDelete(0)) << "of objects that a derived class made";
    cube.reset();
}

TEST_F(GeometryTest, DrawsNothingBeforeInit) {
    Cube cube;
    EXPECT_EQ(cube.count, 0);
    EXPECT_EQ(cube.vao, 0u);
}

}  // namespace
