#include "Markdown.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace lab;
using testing::ElementsAre;

std::vector<std::string> textsOf(const std::vector<Command>& commands) {
    std::vector<std::string> texts;
    for (const Command& each : commands)
        texts.push_back(std::to_string(each.line) + " " + each.text);
    return texts;
}

TEST(Markdown, CommandsAreLinesOfFencedBlocks) {
    EXPECT_THAT(textsOf(commandsIn("Type\n"
                                   "```\n"
                                   "./grade 06-rotation    # grades it\n"
                                   "\n"
                                   "# only a comment\n"
                                   "./grade batch A \\\n"
                                   "    --out B\n"
                                   "cmake --preset dev && ninja\n"
                                   "```\n"
                                   "   ```sh\n"
                                   "   ls\n"
                                   "   ```\n"
                                   "```cpp\n"
                                   "int x;\n"
                                   "```\n")),
                ElementsAre("3 ./grade 06-rotation", "6 ./grade batch A --out B",
                            "8 cmake --preset dev", "8 ninja", "11 ls"));
}

TEST(Markdown, CommandsInTheTextAreOursAndThoseThatBuild) {
    const auto found = commandsIn(
        "Say `./grade --open`, or `ls`, `./grader`, `./test -R x`,\n"
        "`ctest -R x`, `cmake .`, `cmakes`, `ninja`, `docker build .`.\n");
    EXPECT_THAT(textsOf(found), ElementsAre("1 ./grade --open", "1 ./test -R x", "2 ctest -R x",
                                            "2 cmake .", "2 docker build ."));
    EXPECT_TRUE(found[0].inText);
}

TEST(Markdown, BlocksAreCounted) {
    const auto found = commandsIn("```\na\nb\n```\n```\nc\n```\n");
    EXPECT_EQ(found[0].block, found[1].block);
    EXPECT_NE(found[1].block, found[2].block);
}

TEST(Markdown, LinksLeadToFilesAndHeadings) {
    std::vector<std::string> targets;
    for (const Link& each : linksIn("[a](docs/a.md), ![p](p.png) [h](#here)\n"
                                    "[away](https://example.org) `[no](code)`\n"
                                    "```\n[no](block)\n```\n"))
        targets.push_back(each.target);
    EXPECT_THAT(targets, ElementsAre("docs/a.md", "p.png", "#here"));
}

TEST(Markdown, AnchorsAreThoseOfHeadings) {
    EXPECT_THAT(anchorsOf("# Grading a class\n## `limits`, and more!\n```\n# no heading\n```\n"),
                ElementsAre("grading-a-class", "limits-and-more"));
}

}  // namespace
