#include <Cube.h>
#include <cg/GlTest.h>
#include <cg/NormalShader.h>
#include <cg/Resources.h>

namespace {

using NormalShaderTest = cg::GlTest;

TEST_F(NormalShaderTest, DrawsTheFrontOfACubeInTheColourOfItsNormal) {
    cg::addResourceFolder(CG_FOLDER);
    NormalShader shader;
    shader.read_source("shaders/projective.vert", "shaders/normal.frag");
    shader.compile();
    glUseProgram(shader.program);
    shader.initUniforms();
    EXPECT_NE(shader.modelview_loc, -1);
    EXPECT_NE(shader.projection_loc, -1);
    // The nearer face, z = 0.5, must win: with the z axis reversed it is the one at depth -0.5.
    shader.projection = glm::mat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);
    shader.setUniforms();

    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    Cube cube;
    cube.init();
    cube.draw();
    const cg::Pixels pixels = context->readPixels();
    const std::uint8_t* centre = &pixels.rgba[(24 * pixels.width + 32) * 4];
    EXPECT_NEAR(centre[0], 128, 1);
    EXPECT_NEAR(centre[1], 128, 1);
    EXPECT_EQ(centre[2], 255);
}

}  // namespace
