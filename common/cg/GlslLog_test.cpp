#include <cg/GlslLog.h>

#include <gtest/gtest.h>

namespace {

using cg::nameGlslLog;

TEST(GlslLog, NamesThePlacesOfEveryDriver) {
    EXPECT_EQ(nameGlslLog("0:12(5): error: no `x'\n", "a.frag"), "a.frag:12: error: no `x'");
    EXPECT_EQ(nameGlslLog("0(7) : error C1008: undefined\n", "a.frag"),
              "a.frag:7: error C1008: undefined");
    EXPECT_EQ(nameGlslLog("ERROR: 0:3: 'x' : undeclared\n", "a.frag"),
              "a.frag:3: error: 'x' : undeclared");
    EXPECT_EQ(nameGlslLog("WARNING: 0:4: extension", "a.frag"), "a.frag:4: warning: extension");
}

TEST(GlslLog, KeepsOtherLinesAndDropsBlankOnes) {
    EXPECT_EQ(nameGlslLog("error: no main\n\n0:1(2): error: b\n", "a.frag"),
              "error: no main\na.frag:1: error: b");
    EXPECT_EQ(nameGlslLog(std::string("x\0y", 3), "a.frag"), "x");
    EXPECT_EQ(nameGlslLog("", "a.frag"), "");
}

TEST(GlslLog, ALongMessageIsReadLikeAShortOne) {
    const std::string name(1 << 20, '1');
    EXPECT_EQ(nameGlslLog("0:1(5): error: no `" + name + "'", "a.frag"),
              "a.frag:1: error: no `" + name + "'");
    EXPECT_EQ(cg::glslHint("0:2(5): error: no x", "#version 330 core\nx" + name), "");
}

TEST(GlslLog, HintsAtTextBeforeTheVersionAndAtNoComment) {
    const std::string log = "0:2(1): error: no `x'\n";
    EXPECT_NE(cg::glslHint(log, "// the #version\nfloat x;\n#version 330 core\n"), "");
    EXPECT_EQ(cg::glslHint(log, "/* the #version\n*/ # version 330 core\n"), "");
}

}  // namespace
