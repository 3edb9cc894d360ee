#include "SurfaceShader.h"

#include <cg/GlTest.h>

namespace {

const char* const vertexSource =
    "#version 330 core\n"
    "layout (location = 0) in vec3 vertex_position;\n"
    "uniform mat4 modelview, projection;\n"
    "void main() { gl_Position = projection * modelview * vec4(vertex_position, 1.0); }\n";

// Reads every uniform, so that none is optimised away.
const char* const fragmentSource =
    "#version 330 core\n"
    "uniform mat4 view;\n"
    "uniform vec4 ambient, diffuse, specular, emision;\n"
    "uniform float shininess;\n"
    "uniform bool enablelighting;\n"
    "uniform int nlights;\n"
    "uniform vec4 lightpositions[10], lightcolors[10];\n"
    "out vec4 fragColor;\n"
    "void main() {\n"
    "    fragColor = view * (ambient + diffuse + specular + emision) + vec4(shininess);\n"
    "    for (int i = 0; enablelighting && i < nlights; ++i)\n"
    "        fragColor += lightpositions[i] * lightcolors[i];\n"
    "}\n";

class SurfaceShaderTest : public cg::GlTest {
protected:
    SurfaceShaderTest() {
        shader.vertexshader_source = vertexSource;
        shader.fragmentshader_source = fragmentSource;
        shader.compile();
        glUseProgram(shader.program);
        shader.initUniforms();
    }
    ~SurfaceShaderTest() override { glUseProgram(0); }

    GLint at(const char* name) const { return glGetUniformLocation(shader.program, name); }
    glm::vec4 vec4Of(const char* name) const {
        glm::vec4 value(-1.0f);
        glGetUniformfv(shader.program, at(name), &value[0]);
        return value;
    }
    int intOf(const char* name) const {
        GLint value = -1;
        glGetUniformiv(shader.program, at(name), &value);
        return value;
    }

    SurfaceShader shader;
};

TEST_F(SurfaceShaderTest, HandsEveryMemberOver) {
    Material material{{.1f, .2f, .3f, 1}, {.4f, .5f, .6f, 1}, {.7f, .8f, .9f, 1}, {1, 2, 3, 1}, 42};
    shader.view[3] = {4, 5, 6, 1};
    shader.modelview[3] = {7, 8, 9, 1};
    shader.projection[0][0] = 3.0f;
    shader.material = &material;
    shader.enablelighting = GL_TRUE;
    shader.nlights = 1;
    shader.lightpositions = {{1, 2, 3, 0}, {4, 5, 6, 1}};
    shader.lightcolors = {{.1f, .2f, .3f, 1}, {.4f, .5f, .6f, 1}};
    shader.setUniforms();

    for (const auto& [name, expected] : {std::pair("view", shader.view),
                                         {"modelview", shader.modelview},
                                         {"projection", shader.projection}}) {
        glm::mat4 value(0.0f);
        glGetUniformfv(shader.program, at(name), &value[0][0]);
        EXPECT_EQ(value, expected) << name;
    }
    EXPECT_EQ(vec4Of("ambient"), material.ambient);
    EXPECT_EQ(vec4Of("diffuse"), material.diffuse);
    EXPECT_EQ(vec4Of("specular"), material.specular);
    EXPECT_EQ(vec4Of("emision"), material.emision);
    float shininess = 0.0f;
    glGetUniformfv(shader.program, at("shininess"), &shininess);
    EXPECT_EQ(shininess, 42.0f);
    EXPECT_EQ(intOf("enablelighting"), 1);
    EXPECT_EQ(intOf("nlights"), 1);
    EXPECT_EQ(vec4Of("lightpositions[1]"), shader.lightpositions[1]);
    EXPECT_EQ(vec4Of("lightcolors[1]"), shader.lightcolors[1]);
}

TEST_F(SurfaceShaderTest, WithoutLightsAndMaterialItIsSafe) {
    shader.setUniforms();
    EXPECT_EQ(intOf("nlights"), 0);
    EXPECT_EQ(vec4Of("diffuse"), Material().diffuse);
}

TEST_F(SurfaceShaderTest, MoreThanTenLightsAreCut) {
    shader.lightpositions.assign(12, glm::vec4(5.0f));
    shader.lightcolors.assign(12, glm::vec4(6.0f));
    shader.nlights = 12;
    shader.setUniforms();
    EXPECT_EQ(vec4Of("lightpositions[9]"), glm::vec4(5.0f));
    EXPECT_EQ(vec4Of("lightcolors[9]"), glm::vec4(6.0f));
    EXPECT_EQ(intOf("nlights"), 10);
}

TEST_F(SurfaceShaderTest, AProgramWithoutTheseUniformsIsFine) {
    shader.fragmentshader_source =
        "#version 330 core\nout vec4 fragColor;\nvoid main() { fragColor = vec4(1.0); }\n";
    shader.compile();
    glUseProgram(shader.program);
    shader.initUniforms();
    shader.lightpositions.assign(1, glm::vec4(5.0f));
    shader.setUniforms();
}

}  // namespace
