#include "Square.h"

#include <Shader.h>
#include <cg/GlTest.h>

namespace {

using SquareTest = cg::GlTest;

const char* const vertexSource = R"(#version 330 core
layout (location = 0) in vec2 position;
layout (location = 1) in vec3 color;
out vec3 shade;
void main() { shade = color; gl_Position = vec4(position, 0.0, 1.0); })";
const char* const fragmentSource = R"(#version 330 core
in vec3 shade;
out vec4 fragColor;
void main() { fragColor = vec4(shade, 1.0); })";

TEST_F(SquareTest, ShowsItsColoursFromTheFrontOnly) {
    Shader shader;
    shader.vertexshader_source = vertexSource;
    shader.fragmentshader_source = fragmentSource;
    shader.compile();
    glUseProgram(shader.program);
    glEnable(GL_CULL_FACE);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);

    const glm::vec3 red(1, 0, 0), green(0, 1, 0);
    Square square;
    square.init(glm::vec2(0.5f, 0.0f), 1.0f, red, red, green, green);
    square.draw();

    const cg::Pixels pixels = context->readPixels();
    const auto at = [&](int x, int y) { return &pixels.rgba[(y * pixels.width + x) * 4]; };
    EXPECT_EQ(at(16, 24)[1], 0) << "left of the square";
    EXPECT_GT(at(48, 14)[1], 200) << "the upper edge is green";
    EXPECT_GT(at(48, 34)[0], 200) << "the lower edge is red";
    EXPECT_EQ(at(48, 5)[1], 0) << "above the square";
}

TEST_F(SquareTest, WithoutColoursHasPositionsOnly) {
    Square square;
    square.init(glm::vec2(0), 2.0f);
    EXPECT_EQ(square.buffers.size(), 2u);
    EXPECT_EQ(square.count, 6);
}

}  // namespace
