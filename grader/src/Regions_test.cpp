#include "Regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

const std::string kTwo =
    "before\n"
    "    // BEGIN TODO(rotate-right): turn the eye\n"
    "    one();\n"
    "    two();\n"
    "    // END TODO(rotate-right)\n"
    "between\n"
    "// BEGIN TODO(rotate_up2)\n"
    "// END TODO(rotate_up2)\n"
    "after\n";

TEST(Regions, AreFoundWithWholeLines) {
    EXPECT_THAT(regionsOf(kTwo), ElementsAre(Pair("rotate-right", "    one();\n    two();\n"),
                                             Pair("rotate_up2", "")));
}

TEST(Regions, ATextNeedNotHaveAny) {
    EXPECT_THAT(regionsOf(""), IsEmpty());
    EXPECT_THAT(regionsOf("int main() {}\n// TODO: nothing\n"), IsEmpty());
    EXPECT_EQ(outsideRegions("int main() {}"), "int main() {}");
}

TEST(Regions, StandInShadersToo) {
    const std::string shader =
        "#version 330\nvoid main() {\n    // BEGIN TODO(phong)\n    c = vec4(1);\n"
        "    // END TODO(phong)\n}\n";
    EXPECT_THAT(regionsOf(shader), ElementsAre(Pair("phong", "    c = vec4(1);\n")));
}

TEST(Regions, TheLastLineNeedNoNewline) {
    EXPECT_THAT(regionsOf("// BEGIN TODO(a)\nx\n// END TODO(a)"), ElementsAre(Pair("a", "x\n")));
    EXPECT_THAT(regionsOf("// BEGIN TODO(a)"), IsEmpty());
}

TEST(Regions, AnUnclosedOneIsLeftOutAndHidesNoOther) {
    const std::string text =
        "// BEGIN TODO(open)\nx\n// BEGIN TODO(a)\ny\n// END TODO(a)\n// END TODO(other)\n";
    EXPECT_THAT(regionsOf(text), ElementsAre(Pair("a", "y\n")));
    EXPECT_EQ(withRegion(text, "open", "new\n"), std::nullopt);
}

TEST(Regions, MarksWithoutEndTakeNoLongerThanTheirText) {
    // Quadratic, each of these would take minutes.
    std::string doubled, onOneLine, unclosed;
    for (int i = 0; i < 150000; ++i) {
        doubled += "// BEGIN TODO(a)\n";
        onOneLine += "// BEGIN TODO(a" + std::to_string(i) + ")";
        unclosed += "// BEGIN TODO(";
    }
    for (const std::string& marks : {doubled, onOneLine, unclosed})
        EXPECT_THAT(regionsOf(marks + std::string(1 << 20, '/') + "// END TODO(a1)"), IsEmpty());
}

TEST(Regions, ADoubledOneIsLeftOut) {
    const std::string twice =
        "// BEGIN TODO(a)\nx\n// END TODO(a)\n// BEGIN TODO(a)\ny\n// END TODO(a)\n";
    EXPECT_THAT(regionsOf(twice), IsEmpty());
    EXPECT_EQ(withRegion(twice, "a", "new\n"), std::nullopt);
    EXPECT_EQ(outsideRegions(twice), twice);
    EXPECT_THAT(regionsOf("// BEGIN TODO(a)\n// BEGIN TODO(a)\nx\n// END TODO(a)\n"), IsEmpty());
}

TEST(Regions, OneInsideAnotherBelongsToTheOuter) {
    const std::string nested =
        "1\n// BEGIN TODO(a)\n2\n// BEGIN TODO(b)\n3\n// END TODO(b)\n// END TODO(a)\n4\n";
    EXPECT_THAT(regionsOf(nested),
                ElementsAre(Pair("a", "2\n// BEGIN TODO(b)\n3\n// END TODO(b)\n")));
    EXPECT_EQ(outsideRegions(nested), "1\n// BEGIN TODO(a)\n// END TODO(a)\n4\n");
}

TEST(Regions, AreReplacedWithNothingElseTouched) {
    EXPECT_EQ(withRegion(kTwo, "rotate_up2", "    new();\n"),
              kTwo.substr(0, kTwo.find("// END TODO(rotate_up2)")) + "    new();\n" +
                  kTwo.substr(kTwo.find("// END TODO(rotate_up2)")));
    const auto changed = withRegion(kTwo, "rotate-right", "    new();\n");
    ASSERT_TRUE(changed);
    EXPECT_EQ(regionsOf(*changed).at("rotate-right"), "    new();\n");
    EXPECT_EQ(outsideRegions(*changed), outsideRegions(kTwo));
    EXPECT_EQ(withRegion(kTwo, "none", "x"), std::nullopt);
}

TEST(Regions, WhatIsOutsideKeepsTheFences) {
    EXPECT_EQ(outsideRegions(kTwo),
              "before\n    // BEGIN TODO(rotate-right): turn the eye\n"
              "    // END TODO(rotate-right)\nbetween\n// BEGIN TODO(rotate_up2)\n"
              "// END TODO(rotate_up2)\nafter\n");
}

// A student's file may hold anything.
TEST(Regions, AVeryLongLineIsNoTrouble) {
    const std::string text =
        "// BEGIN TODO(a)" + std::string(1 << 20, 'x') + "\ny\n// END TODO(a)\n";
    EXPECT_THAT(regionsOf(text), ElementsAre(Pair("a", "y\n")));
}

}  // namespace
