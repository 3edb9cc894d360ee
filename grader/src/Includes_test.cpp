#include "Includes.h"

#include <gmock/gmock.h>

namespace {

using namespace grader;
using testing::ElementsAre;

TEST(Includes, AreNamedByTheirLastPart) {
    const std::string text =
        "#include \"Camera.h\"  // mine\n# include <glm/glm.hpp>\n#include \"a/../b/scene.h\"\n"
        "int include = 3;\n";
    EXPECT_TRUE(includesOnlyHeaders(text));
    EXPECT_THAT(includedNames(text), ElementsAre("Camera.h", "glm.hpp", "scene.h"));
}

TEST(Includes, WhatIsMadeUpOrHiddenIsNotTakenForAHeader) {
    for (const char* text : {"#include \"scene.cpp\"", "#include NAME", "#include \\\n\"x.h\"",
                             "#inc\\ \nlude \"x.h\"", "%:include \"x.h\"",
                             "#if __has_include(\"x.h\")", "asm(\".incbin 1\");"})
        EXPECT_FALSE(includesOnlyHeaders(text)) << text;
}

TEST(Includes, CommentsThatCannotBeAnythingElseAreTakenOut) {
    EXPECT_EQ(withoutComments("// Ann\nint a;  // one\n\tint b;//two\n"), "\nint a;\n\tint b;\n");
    EXPECT_EQ(withoutComments("a = b / c;\n"), "a = b / c;\n");
}

TEST(Includes, AnyOtherCommentStays) {
    for (const std::string text :
         {"s = \"//x\";  // y\n", "c = '\"';  // y\n", "#define A  // y\n", "#include <a//b.h>\n",
          "/* a\n// b */ int c;\n", "s = R\"(\n// text)\";\n", "// a \\\nint b;\n",
          "// a \\ \nint b;\n",
          "// a ?"
          "?/\nint b;\n",
          "f();  // Falls through\n", "// \u202e\n", "// a\rint b;\n"})
        EXPECT_EQ(withoutComments(text), text);
}

}  // namespace
