#include <cg/GlTest.h>
#include <cg/GlslProgram.h>
#include <cg/ShaderProbe.h>
#include <cg/TemporaryFolder.h>
#include <cg/Todo.h>

namespace {

using cg::Uniforms;
using Values = std::vector<glm::vec4>;

class ShaderProbeTest : public cg::GlTest {
protected:
    cg::TemporaryFolder folder;
};

TEST_F(ShaderProbeTest, FragmentValuesAreUnclampedAndInOrder) {
    const std::string path =
        folder.write("scale.frag",
                     "#version 330 core\nin vec4 position;\nin vec3 normal;\n"
                     "uniform float factor;\nout vec4 colour;\n"
                     "void main() { colour = vec4(factor * normal, position.w); }\n");
    Values positions, normals;
    for (int i = 0; i < 300; ++i) {
        positions.emplace_back(0, 0, 0, i);
        normals.emplace_back(i, -i, 0.5f, 0);
    }
    Uniforms uniforms;
    uniforms.floats["factor"] = -984.375f;
    uniforms.floats["absent"] = 1.0f;
    const Values got =
        cg::probeFragment(path, {{"position", positions}, {"normal", normals}}, uniforms);
    ASSERT_EQ(got.size(), 300u);
    for (int i = 0; i < 300; ++i) {
        EXPECT_EQ(got[std::size_t(i)],
                  glm::vec4(-984.375f * float(i), 984.375f * float(i), -984.375f * 0.5f, i));
    }
}

TEST_F(ShaderProbeTest, InputsStandInListsAndNotInComments) {
    const std::string path =
        folder.write("list.frag",
                     "#version 330 core\n// in vec3 a;\nin vec2 b, a;\nout vec4 c;\n"
                     "void main() { c = vec4(a, b); }\n");
    EXPECT_EQ(cg::probeFragment(path, {{"a", {{1, 2, 0, 0}}}, {"b", {{3, 4, 0, 0}}}}, {}).at(0),
              glm::vec4(1, 2, 3, 4));
}

TEST_F(ShaderProbeTest, UniformsOfEveryKindArrive) {
    const std::string path = folder.write(
        "sum.frag",
        "#version 330 core\nin float x;\nuniform int n;\nuniform bool on;\nuniform vec2 b;\n"
        "uniform vec3 c;\nuniform vec4 d[3];\nuniform mat3 m;\nuniform mat4 k;\nout vec4 r;\n"
        "void main() { r = vec4(x + float(n) + (on ? 1.0 : 0.0), b.y + c.z, d[2].w, m[2].x + "
        "k[3].y); }\n");
    Uniforms uniforms;
    uniforms.ints = {{"n", 7}, {"on", 1}};
    uniforms.vec2s["b"] = {0, 2};
    uniforms.vec3s["c"] = {0, 0, 3};
    uniforms.vec4Arrays["d"] = {glm::vec4(0), glm::vec4(0), glm::vec4(0, 0, 0, 5)};
    glm::mat3 m(0.0f);
    m[2].x = 4;
    glm::mat4 k(0.0f);
    k[3].y = 8;
    uniforms.mat3s["m"] = m;
    uniforms.mat4s["k"] = k;
    EXPECT_EQ(cg::probeFragment(path, {{"x", {glm::vec4(0.5f)}}}, uniforms).at(0),
              glm::vec4(8.5f, 5, 5, 12));
}

TEST_F(ShaderProbeTest, AFunctionIsCalledByItself) {
    const std::string path =
        folder.write("f.frag",
                     "// not yet the #version\n# version 330 core\nout vec4 fragColor;\n"
                     "vec2 cprod(vec2 a, vec2 b) {\n"
                     "    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);\n}\n"
                     "void main(void) { fragColor = vec4(1.0); }\n");
    const Values got = cg::probeFunction(path, "cprod", "vec4(cprod(a.xy, a.zw), 0.0, 1.0)",
                                         {{1, 2, 3, 4}, {0, 1, 0, 1}}, {});
    EXPECT_EQ(got, (Values{{-5, 10, 0, 1}, {-1, 0, 0, 1}}));
    EXPECT_THROW(cg::probeFunction(path, "iterate", "vec4(iterate(a.xy))", {{0, 0, 0, 0}}, {}),
                 cg::MissingFunction);
}

TEST_F(ShaderProbeTest, AVaryingOfAVertexShaderIsRead) {
    const std::string path = folder.write(
        "n.vert",
        "#version 330 core\nlayout(location = 1) in vec3 vertex_normal;\n"
        "uniform mat4 modelview;\nout vec3 normal;\nvoid main() {\n"
        "    normal = mat3(modelview) * vertex_normal;\n    gl_Position = vec4(0.0);\n}\n");
    Uniforms uniforms;
    uniforms.mat4s["modelview"] = glm::mat4(2.0f);
    const Values got =
        cg::probeVertex(path, {{1, {{1, 2, 3, 0}, {-4, 5, 6, 0}}}}, "normal", uniforms);
    EXPECT_EQ(got, (Values{{2, 4, 6, 0}, {-8, 10, 12, 0}}));
}

TEST_F(ShaderProbeTest, AFloatPictureHasRowZeroAtTheTop) {
    const std::string vertex =
        folder.write("v.vert",
                     "#version 330 core\nlayout(location = 0) in vec2 p;\nout vec2 q;\n"
                     "void main() { q = p; gl_Position = vec4(p, 0.0, 1.0); }\n");
    const std::string fragment = folder.write("f.frag",
                                              "#version 330 core\nin vec2 q;\nout vec4 c;\n"
                                              "void main() { c = vec4(10.0 * q, 0.0, 1.0); }\n");
    const Values got = cg::renderFloat(vertex, fragment, 4, 2, {});
    ASSERT_EQ(got.size(), 8u);
    EXPECT_NEAR(got[0].x, -7.5f, 1e-4f);
    EXPECT_NEAR(got[0].y, 5.0f, 1e-4f);
    EXPECT_NEAR(got[7].x, 7.5f, 1e-4f);
    EXPECT_NEAR(got[7].y, -5.0f, 1e-4f);
}

TEST_F(ShaderProbeTest, ErrorsKeepTheAuthorsOwnLineNumbers) {
    const std::string path = folder.write("wrong.frag",
                                          "// a comment\n#version 330 core\nout vec4 c;\n"
                                          "float f(float x) {\n    return 0f * x;\n}\n"
                                          "void main() { c = vec4(f(1.0)); }\n");
    const std::string text = cg::messageOf<cg::GlslError>([&] {
        cg::probeFunction(path, "f", "vec4(f(a.x))", {{0, 0, 0, 0}}, {});
    });
    EXPECT_NE(text.find("wrong.frag:5: "), std::string::npos) << text;
    EXPECT_NE(text.find("hint: a float has a decimal point"), std::string::npos) << text;
}

TEST_F(ShaderProbeTest, AnUnfilledRegionIsReported) {
    cg::clearTodos();
    const std::string path =
        folder.write("todo.frag",
                     "#version 330 core\nuniform float cg_todo_many_lights;\nin float x;\n"
                     "uniform float cg_todo_unused;\nout vec4 c;\n"
                     "void main() { c = vec4(x + cg_todo_many_lights); }\n");
    EXPECT_EQ(cg::probeFragment(path, {{"x", {glm::vec4(2)}}}, {}).at(0), glm::vec4(2));
    EXPECT_EQ(cg::reachedTodos(), std::vector<std::string>{"many-lights"});
    cg::clearTodos();
}

TEST_F(ShaderProbeTest, FramebufferAndViewportAreAsBefore) {
    glViewport(1, 2, 30, 20);
    GLint before = -1;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
    const std::string path =
        folder.write("c.frag", "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n");
    cg::probeFragment(path, {{"x", {glm::vec4(0)}}}, {});
    GLint framebuffer = -1, viewport[4] = {};
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_VIEWPORT, viewport);
    EXPECT_EQ(framebuffer, before);
    EXPECT_EQ(viewport[0], 1);
    EXPECT_EQ(viewport[3], 20);
}

}  // namespace
