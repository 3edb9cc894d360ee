#include "Shader.h"

#include <cg/Error.h>
#include <cg/GlTest.h>
#include <cg/Resources.h>
#include <cg/TemporaryFolder.h>

#include <optional>

namespace {

const std::string goodVertex = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
const std::string goodFragment = "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n";
const std::string badFragment =
    "#version 330 core\nout vec4 c;\nvoid main() {\n    c = vec4(nowhere, 1.0);\n}\n";

class ShaderTest : public cg::GlTest {
protected:
    /// Names from 1 up that are shader or program objects now.
    static int objects() {
        int count = 0;
        for (GLuint name = 1; name < 200; ++name) {
            count += glIsShader(name) || glIsProgram(name);
        }
        return count;
    }

    void read(Shader& shader, const std::string& vertex, const std::string& fragment) {
        folder.write("a.vert", vertex);
        folder.write("b.frag", fragment);
        cg::addResourceFolder(folder.path());
        shader.read_source("a.vert", "b.frag");
    }

    cg::TemporaryFolder folder;
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(ShaderTest, CompilesAndLinks) {
    Shader shader;
    read(shader, goodVertex, goodFragment);
    shader.compile();
    EXPECT_TRUE(glIsProgram(shader.program));
    EXPECT_EQ(shader.getVertexShaderCompileStatus(), 1);
    EXPECT_EQ(shader.getFragmentShaderCompileStatus(), 1);
    EXPECT_EQ(shader.getLinkStatus(), 1);
    EXPECT_EQ(objects(), 1);
}

TEST_F(ShaderTest, ACompileErrorNamesFileAndLineAndLeaksNothing) {
    const int before = objects();
    Shader shader;
    read(shader, goodVertex, badFragment);
    const std::string text = cg::messageOf<cg::Error>([&] { shader.compile(); });
    EXPECT_TRUE(contains(text, "b.frag:4: error")) << text;
    EXPECT_TRUE(contains(text, "nowhere")) << text;
    EXPECT_EQ(shader.getVertexShaderCompileStatus(), 1);
    EXPECT_EQ(shader.getFragmentShaderCompileStatus(), 0);
    EXPECT_EQ(shader.program, 0u);
    EXPECT_EQ(objects(), before);
}

TEST_F(ShaderTest, ErrorsOfBothShadersAreReported) {
    Shader shader;
    read(shader, "#version 330 core\nvoid main() { oops }\n", badFragment);
    const std::string text = cg::messageOf<cg::Error>([&] { shader.compile(); });
    EXPECT_TRUE(contains(text, "a.vert:2: error")) << text;
    EXPECT_TRUE(contains(text, "b.frag:4: error")) << text;
}

TEST_F(ShaderTest, ALinkErrorNamesBothFilesAndLeaksNothing) {
    const int before = objects();
    Shader shader;
    read(shader,
         "#version 330 core\nout vec2 both;\n"
         "void main() { both = vec2(1.0); gl_Position = vec4(0.0); }\n",
         "#version 330 core\nin vec3 both;\nout vec4 c;\n"
         "void main() { c = vec4(both, 1.0); }\n");
    const std::string text = cg::messageOf<cg::Error>([&] { shader.compile(); });
    EXPECT_TRUE(contains(text, "a.vert and b.frag do not link")) << text;
    EXPECT_TRUE(contains(text, "both")) << text;
    EXPECT_EQ(shader.getLinkStatus(), 0);
    EXPECT_EQ(objects(), before);
}

TEST_F(ShaderTest, CompilingAgainReplacesTheProgram) {
    Shader shader;
    read(shader, goodVertex, goodFragment);
    for (int round = 0; round < 5; ++round) {
        shader.compile();
        EXPECT_EQ(objects(), 1);
    }
}

TEST_F(ShaderTest, AFailedRecompileKeepsTheFormerProgram) {
    Shader shader;
    read(shader, goodVertex, goodFragment);
    shader.compile();
    const GLuint former = shader.program;
    shader.fragmentshader_source = badFragment;
    EXPECT_THROW(shader.compile(), cg::Error);
    EXPECT_EQ(shader.program, former);
    EXPECT_TRUE(glIsProgram(former));
    EXPECT_EQ(objects(), 1);
}

TEST_F(ShaderTest, TheDestructorDeletesTheProgram) {
    std::optional<Shader> shader(std::in_place);
    read(*shader, goodVertex, goodFragment);
    shader->compile();
    shader.reset();
    EXPECT_EQ(objects(), 0);
}

TEST_F(ShaderTest, DestroyedAfterItsContextLeavesTheNextOneAlone) {
    std::optional<Shader> old(std::in_place);
    read(*old, goodVertex, goodFragment);
    old->compile();
    context.reset();
    context = cg::createOsMesaContext(64, 48);
    Shader shader;
    read(shader, goodVertex, goodFragment);
    shader.compile();
    EXPECT_EQ(old->program, shader.program) << "the test wants equal names in both contexts";
    old.reset();
    EXPECT_TRUE(glIsProgram(shader.program));
}

TEST_F(ShaderTest, AMissingFileIsNamedWithThePlacesTried) {
    Shader shader;
    read(shader, goodVertex, goodFragment);
    const std::string text =
        cg::messageOf<cg::Error>([&] { shader.read_source("a.vert", "absent.frag"); });
    EXPECT_TRUE(contains(text, "absent.frag not found")) << text;
    EXPECT_TRUE(contains(text, folder.path("absent.frag"))) << text;
    EXPECT_EQ(shader.vertexshader_source, goodVertex);
}

TEST_F(ShaderTest, AByteOrderMarkAndWindowsLineEndsAreAccepted) {
    Shader shader;
    read(shader, "\xEF\xBB\xBF#version 330 core\r\nvoid main() { gl_Position = vec4(0.0); }\r\n",
         goodFragment);
    shader.compile();
    EXPECT_EQ(shader.getLinkStatus(), 1);
}

TEST_F(ShaderTest, NeedsAContext) {
    Shader shader;
    read(shader, goodVertex, goodFragment);
    context.reset();
    EXPECT_TRUE(contains(cg::messageOf<cg::Error>([&] { shader.compile(); }),
                         "no OpenGL context is current"));
}

}  // namespace
