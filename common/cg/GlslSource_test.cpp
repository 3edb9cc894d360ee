#include <cg/GlslSource.h>

#include <gtest/gtest.h>

namespace {

using cg::beginsWithVersion;
using cg::definesFunction;
using cg::insertAfterVersion;
using cg::typeOfInput;

const std::string longComment = "/*" + std::string(1 << 20, '\n') + "*/";
const std::string longSpace = std::string(1 << 20, ' ');

TEST(GlslSource, OnlySpaceAndCommentsStandBeforeTheVersion) {
    EXPECT_TRUE(beginsWithVersion("#version 330 core\n"));
    EXPECT_TRUE(beginsWithVersion("\n  #\tversion 330 core\n"));
    EXPECT_TRUE(beginsWithVersion("// #version 120\r\n/* x; */ #version 330 core\n"));
    EXPECT_TRUE(beginsWithVersion(longComment + longSpace + "#version 330 core\n"));
    EXPECT_FALSE(beginsWithVersion("float x;\n#version 330 core\n"));
    EXPECT_FALSE(beginsWithVersion("// #version 330 core\nfloat x;\n"));
    EXPECT_FALSE(beginsWithVersion("/* #version 330 core"));
    EXPECT_FALSE(beginsWithVersion(""));
}

TEST(GlslSource, TextIsInsertedAfterTheVersion) {
    EXPECT_EQ(insertAfterVersion("#version 330 core\n\nfloat x;\n", "float y;\n"),
              "#version 330 core\n\n\nfloat y;\n#line 3\nfloat x;\n");
    EXPECT_EQ(insertAfterVersion("// #version 120\n# version 330\nfloat x;", "float y;\n"),
              "// #version 120\n# version 330\n\nfloat y;\n#line 3\nfloat x;");
    EXPECT_EQ(insertAfterVersion("#version 330 /* a\nb */ float x;", "float y;\n"),
              "#version 330 /* a\nb */ \nfloat y;\n#line 2\nfloat x;");
    EXPECT_EQ(insertAfterVersion("// #version 330\nfloat x;", "float y;\n"),
              "// #version 330\n\nfloat y;\n#line 2\nfloat x;");
    EXPECT_EQ(insertAfterVersion("#version 330", "float y;\n"),
              "#version 330\nfloat y;\n#line 1\n");
}

TEST(GlslSource, AnInputHasTheTypeOfItsList) {
    const std::string source = "in vec3 a, normal;\nflat in highp vec2 /* x */ uv ;in float f;";
    EXPECT_EQ(typeOfInput(source, "a"), "vec3");
    EXPECT_EQ(typeOfInput(source, "normal"), "vec3");
    EXPECT_EQ(typeOfInput(source, "uv"), "vec2");
    EXPECT_EQ(typeOfInput(source, "f"), "float");
    EXPECT_EQ(typeOfInput("// in vec3 p;\n/* in vec2 p; */ in vec4 p;", "p"), "vec4");
    EXPECT_EQ(typeOfInput("in" + longComment + longSpace + "vec3 p;", "p"), "vec3");
}

TEST(GlslSource, OtherVariablesAreNoInputs) {
    EXPECT_EQ(typeOfInput("in vec3 p;", "q"), "");
    EXPECT_EQ(typeOfInput("// in vec3 p;", "p"), "");
    EXPECT_EQ(typeOfInput("out vec3 p; in mat3 p; in int p; in", "p"), "");
    EXPECT_EQ(typeOfInput("vec3 f(in vec3 a, vec3 p) { vec3 p; } vec3 g(in vec3 p);", "p"), "");
}

TEST(GlslSource, AFunctionHasABody) {
    EXPECT_TRUE(definesFunction("vec2 f(vec2 a, vec2 b)\n{", "f"));
    EXPECT_TRUE(definesFunction("float" + longComment + "f( /* ) */ )" + longSpace + "{", "f"));
    EXPECT_FALSE(definesFunction("float f(float x); float g() { return f(1.0); }", "f"));
    EXPECT_FALSE(definesFunction("// float f() {\n/* float f() { */", "f"));
    EXPECT_FALSE(definesFunction("float ff() { } float f(", "f"));
}

}  // namespace
