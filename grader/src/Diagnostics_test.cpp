#include "Diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Process.h"
#include "testing/Tree.h"

namespace grader {
static bool operator==(const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.file, a.line, a.column, a.severity, a.message) ==
           std::tie(b.file, b.line, b.column, b.severity, b.message);
}
static void PrintTo(const Diagnostic& each, std::ostream* out) {
    *out << placeOf(each) << each.severity << ": " << each.message;
}
}  // namespace grader

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_help::Tree;

Diagnostic error(const std::string& file, int line, int column, const std::string& message) {
    return {file, line, column, "error", message};
}

std::string hintOf(const std::string& message) {
    return hintFor(error("Camera.cpp", 1, 1, message));
}

TEST(Diagnostics, ErrorsAndWarningsOfGcc) {
    EXPECT_THAT(parseDiagnostics("./Camera.cpp:17:5: error: 'x' was not declared in this scope\n"
                                 "Camera.h:3:1: warning: unused [-Wunused]\n"
                                 "rotation.cpp:1:10: fatal error: nope.h: No such file\n"),
                ElementsAre(error("Camera.cpp", 17, 5, "'x' was not declared in this scope"),
                            Diagnostic{"Camera.h", 3, 1, "warning", "unused [-Wunused]"},
                            error("rotation.cpp", 1, 10, "nope.h: No such file")));
}

TEST(Diagnostics, AMissingReturnHasAHint) {
    for (const char* message : {"no return statement in function returning non-void",
                                "control reaches end of non-void function [-Wreturn-type]"})
        EXPECT_THAT(hintOf(message), HasSubstr("ends in a return"));
}

TEST(Diagnostics, OfAFileWithAFolderOfOursOnlyTheNameIsLeft) {
    EXPECT_THAT(
        parseDiagnostics("/tmp/course-x/held/rotation.cpp:3:1: error: oops\n"
                         "shaders/part.h:2:1: error: oops\n"),
        ElementsAre(error("rotation.cpp", 3, 1, "oops"), error("shaders/part.h", 2, 1, "oops")));
}

TEST(Diagnostics, WhatIsSaidOfOneHeaderTwiceIsKeptOnce) {
    const Diagnostic first = error("Camera.h", 3, 1, "oops"), other = error("Camera.h", 3, 1, "no"),
                     below = error("Camera.h", 4, 1, "oops");
    std::vector<Diagnostic> all = {first, other, first, below, first};
    dropRepeated(all);
    EXPECT_THAT(all, ElementsAre(first, other, below));
}

TEST(Diagnostics, AColumnMayBeMissing) {
    EXPECT_THAT(parseDiagnostics("g.cpp:12: error: unterminated #if"),
                ElementsAre(error("g.cpp", 12, 0, "unterminated #if")));
}

TEST(Diagnostics, EverythingElseIsLeftOut) {
    EXPECT_THAT(parseDiagnostics("Camera.cpp: In member function 'void Camera::f()':\n"
                                 "Camera.cpp:3:7: note: candidate is 'a'\n"
                                 "   17 |     int error: 5:3: error: x;\n"
                                 "      |     ^~~~\n"
                                 "In file included from Camera.cpp:1:\n"
                                 "compilation terminated.\n"
                                 "cc1plus: all warnings being treated as errors\n"
                                 "collect2: error: ld returned 1 exit status\n\n"),
                IsEmpty());
}

TEST(Diagnostics, TypesOfGlmAndQuotesAreSimple) {
    EXPECT_THAT(
        parseDiagnostics(
            "f.cpp:3:40: error: conversion from \u2018glm::mat4\u2019 {aka \u2018glm::mat<4, "
            "4, float, glm::packed_highp>\u2019} to non-scalar type \u2018glm::vec<3, float, "
            "glm::packed_highp>\u2019 requested"),
        ElementsAre(error("f.cpp", 3, 40,
                          "conversion from 'glm::mat4' to non-scalar type 'glm::vec3' requested")));
    EXPECT_THAT(parseDiagnostics("f.cpp:1:1: error: glm::mat<3, 3, float, glm::packed_highp> and "
                                 "glm::vec<2, float>"),
                ElementsAre(error("f.cpp", 1, 1, "glm::mat3 and glm::vec2")));
}

TEST(Diagnostics, WhatOtherSystemsAcceptHasAHint) {
    EXPECT_THAT(hintOf("camera.h: No such file or directory, but there is Camera.h"),
                HasSubstr("upper and lower case"));
    EXPECT_EQ(hintOf("lens.h: No such file or directory"), "");
    EXPECT_THAT(hintOf("'M_PI' was not declared in this scope"), HasSubstr("std::numbers::pi"));
}

TEST(Diagnostics, ForgedNumbersAndLongLinesAreNoTrouble) {
    EXPECT_THAT(parseDiagnostics("Camera.cpp:99999999999999999999:1: error: forged"), IsEmpty());
    const auto all = parseDiagnostics("Camera.cpp:1:1: error: " + std::string(1 << 20, 'x'));
    ASSERT_EQ(all.size(), 1u);
    EXPECT_LE(all[0].message.size(), 2000u);
}

TEST(Diagnostics, APlaceIsAsMuchAsIsKnown) {
    EXPECT_EQ(placeOf(error("Camera.cpp", 17, 5, "")), "Camera.cpp:17:5: ");
    EXPECT_EQ(placeOf(error("Camera.cpp", 17, 0, "")), "Camera.cpp:17: ");
    EXPECT_EQ(placeOf(error("Camera.cpp", 0, 0, "")), "Camera.cpp: ");
    EXPECT_EQ(placeOf(error("", 0, 0, "")), "");
}

TEST(SourceLine, IsTheLineWithItsTabsAsTheCompilerCountsThem) {
    const std::string text = "one\n\tint x;\n\n  é\ty\nlast";
    EXPECT_EQ(sourceLine(text, 1), "one");
    EXPECT_EQ(sourceLine(text, 2), "        int x;");
    EXPECT_EQ(sourceLine(text, 3), "");
    EXPECT_EQ(sourceLine(text, 4), "  é     y") << "é is two bytes and one column";
    EXPECT_EQ(sourceLine(text, 5), "last");
}

TEST(SourceLine, IsEmptyWhereThereIsNoneOrTooMuchOfIt) {
    EXPECT_EQ(sourceLine("one\n", 0), "");
    EXPECT_EQ(sourceLine("one\n", 2), "");
    EXPECT_EQ(sourceLine("one\n", 999999999), "");
    EXPECT_EQ(sourceLine(std::string(400, 'x'), 1).size(), 400u);
    EXPECT_EQ(sourceLine(std::string(401, 'x'), 1), "");
}

// Columns are counted by the compiler; the caret stands under the name only if we count alike.
TEST(SourceLine, HasItsColumnsWhereTheCompilerSaysTheyAre) {
    const Tree tree;
    const std::string text = "int f() {\n\tint é = 1; return nope;\n}\n";
    const auto file = tree.write("a.cpp", text);
    const auto output =
        run({"g++", "-c", file.string(), "-o", "/dev/null", "-fno-diagnostics-show-caret"}, 30)
            .output;
    const auto all = parseDiagnostics(output);
    ASSERT_EQ(all.size(), 1u) << output;
    const std::string line = sourceLine(text, all[0].line);
    const std::size_t wide = std::string("é").size() - 1;
    EXPECT_EQ(line.find("nope"), static_cast<std::size_t>(all[0].column) - 1 + wide) << line;
}

// What the four linkers print for two definitions of one function, as captured from them.
TEST(LinkerDiagnostics, OfGnuLd) {
    EXPECT_THAT(
        parseDiagnostics(
            "/usr/bin/ld.bfd: /tmp/course-aBc/out/Camera.cpp.o: in function `rotation(float)':\n"
            "././Camera.cpp:9: multiple definition of `rotation(float)'; "
            "/tmp/course-aBc/out/rotation.cpp.o:././rotation.cpp:4: first defined here\n"
            "collect2: error: ld returned 1 exit status\n"),
        ElementsAre(error("Camera.cpp", 9, 0,
                          "multiple definition of 'rotation(float)', defined before in "
                          "rotation.cpp:4")));
    EXPECT_THAT(
        parseDiagnostics(
            "/usr/bin/ld: /tmp/course-x/out/w.cpp.o:(.data+0x0): multiple definition of "
            "`v'; /tmp/course-x/out/v.cpp.o:(.data+0x0): first defined here\n"),
        ElementsAre(error("w.cpp", 0, 0, "multiple definition of 'v', defined before in v.cpp")));
}

TEST(LinkerDiagnostics, OfMold) {
    EXPECT_THAT(parseDiagnostics(
                    "mold: error: duplicate symbol: /tmp/course-x/out/inherited.a(rotation.cpp.o): "
                    "/tmp/course-x/out/Camera.cpp.o: a::rotation(float)\n"),
                ElementsAre(error("rotation.cpp", 0, 0,
                                  "multiple definition of 'a::rotation(float)', defined before in "
                                  "Camera.cpp")));
}

TEST(LinkerDiagnostics, OfACopyThatAFileManagerNamed) {
    const auto twice =
        ElementsAre(error("rotation.cpp", 0, 0,
                          "multiple definition of 'rotation(glm::vec3)', defined before in "
                          "rotation (copy).cpp"));
    const std::string symbol = "rotation(glm::vec<3, float, (glm::qualifier)0>)";
    const std::string out = "/tmp/course-x/out/";
    EXPECT_THAT(parseDiagnostics("mold: error: duplicate symbol: " + out + "rotation.cpp.o: " +
                                 out + "rotation (copy).cpp.o: " + symbol + "\n"),
                twice);
    EXPECT_THAT(
        parseDiagnostics("/usr/bin/ld: " + out +
                         "rotation.cpp.o:(.text+0x0): multiple definition of `" + symbol + "'; " +
                         out + "rotation (copy).cpp.o:(.text+0x0): first defined here\n"),
        twice);
}

TEST(LinkerDiagnostics, OfGoldAndLld) {
    EXPECT_THAT(
        parseDiagnostics("/usr/bin/ld.gold: error: /tmp/c/out/a.cpp.o: multiple definition of "
                         "'rotation(float)'\n/usr/bin/ld.gold: /tmp/c/out/b.cpp.o: previous "
                         "definition here\n"),
        ElementsAre(error("a.cpp", 0, 0, "multiple definition of 'rotation(float)'")));
    EXPECT_THAT(parseDiagnostics("ld.lld: error: duplicate symbol: rotation(float)\n"
                                 ">>> defined at b.cpp:1 (./b.cpp:1)\n"),
                ElementsAre(error("", 0, 0, "multiple definition of 'rotation(float)'")));
}

/// The linkers that are installed, asked for real.
class Linker : public testing::TestWithParam<const char*> {};

TEST_P(Linker, TwoDefinitionsAreNamedWithoutFoldersOfTheBuild) {
    const Tree tree;
    tree.write("one.cpp", "float rotation(float d) { return d; }\n");
    tree.write("two.cpp", "\n\nfloat rotation(float d) { return 2 * d; }\n");
    const std::string here = tree.path().string();
    std::vector<std::string> objects;
    for (const std::string name : {"one.cpp", "two.cpp"}) {
        objects.push_back(here + "/" + name + ".o");
        const auto compiled = run({"g++", "-g1", "-fPIC", "-ffile-prefix-map=" + here + "=.", "-c",
                                   here + "/" + name, "-o", objects.back()},
                                  30);
        ASSERT_TRUE(compiled.succeeded()) << compiled.output;
    }
    const std::string linker = GetParam();
    if (!run({"g++", "-fuse-ld=" + linker, "-shared", objects[0], "-o", here + "/one.so"}, 30)
             .succeeded())
        GTEST_SKIP() << "g++ -fuse-ld=" << linker << " does not run here";
    const auto linked = run(
        {"g++", "-fuse-ld=" + linker, "-shared", objects[0], objects[1], "-o", here + "/both.so"},
        30);
    EXPECT_FALSE(linked.succeeded());
    const auto all = parseDiagnostics(linked.output);
    ASSERT_EQ(all.size(), 1u) << linked.output;
    EXPECT_THAT(all[0].message, HasSubstr("multiple definition of 'rotation(float)'"));
    EXPECT_EQ(all[0].message.find("course-"), std::string::npos) << all[0].message;
    if (linker == "bfd" || linker == "mold") {
        EXPECT_EQ(all[0].file, "two.cpp") << linked.output;
        EXPECT_THAT(all[0].message, HasSubstr("one.cpp"));
    }
    EXPECT_THAT(hintFor(all[0]), HasSubstr("keep one of them"));
}

INSTANTIATE_TEST_SUITE_P(Installed, Linker, testing::Values("bfd", "mold", "gold", "lld"),
                         [](const auto& each) { return std::string(each.param); });

TEST(Hints, NearAndFarAreSpecial) {
    const std::string hint =
        hintOf("'struct Camera' has no member named 'near'; did you mean 'zNear'?");
    EXPECT_THAT(hint, HasSubstr("near and far"));
    EXPECT_THAT(hint, HasSubstr("Windows"));
    EXPECT_EQ(hintOf("'struct Camera' has no member named 'far'"), hint);
    EXPECT_NE(hintOf("'struct Camera' has no member named 'nearest'"), hint);
}

TEST(Hints, ForCommonMistakes) {
    EXPECT_THAT(hintOf("no declaration matches 'void Camera::h()'"), HasSubstr("header"));
    EXPECT_THAT(hintOf("expected ';' before 'return'"), HasSubstr("semicolon"));
    EXPECT_THAT(hintOf("'cros' was not declared in this scope"), HasSubstr("spelling"));
    EXPECT_THAT(hintOf("expected '}' at end of input"), HasSubstr("closing brace"));
    EXPECT_EQ(hintOf("something new"), "");
}

// The compiler quotes with other signs where the locale has them; the hints must come all the same.
TEST(Hints, ComeForWhatTheCompilerReallyPrints) {
    const Tree tree;
    const auto file = tree.write("a.cpp",
                                 "struct Camera { float zNear; };\n"
                                 "float f(Camera c) { return c.near; }\nint g() { return 1 }\n");
    const auto output = run({"env", "LANG=C.UTF-8", "LC_ALL=C.UTF-8", "g++", "-c", file.string(),
                             "-o", "/dev/null", "-fno-diagnostics-show-caret"},
                            30)
                            .output;
    const auto all = parseDiagnostics(output);
    ASSERT_EQ(all.size(), 2u) << output;
    EXPECT_EQ(all[0].line, 2);
    EXPECT_THAT(hintFor(all[0]), HasSubstr("Windows")) << output;
    EXPECT_THAT(hintFor(all[1]), HasSubstr("semicolon")) << output;
}

TEST(Diagnostics, FoldersAreNobodysBusiness) {
    EXPECT_EQ(withoutFolders("/usr/bin/ld: /tmp/course-1/out/a.o: cannot open ../x/y.cpp"),
              "ld: a.o: cannot open y.cpp");
    EXPECT_EQ(withoutFolders("a / b, 1/2 and 'cg/Todo.h'"), "a / b, 1/2 and 'cg/Todo.h'");
    const auto found = parseDiagnostics("a.cpp:1:2: fatal error: /root/b.h: No such file\n");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].message, "b.h: No such file");
}

}  // namespace
