#include "pull_request/Markdown.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace grader;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Markdown, ATextIsShownAsItIs) {
    EXPECT_EQ(escapedMarkdown("expected (-3, 6.5), got 2: no"), "expected (-3, 6.5), got 2: no");
    EXPECT_EQ(escapedMarkdown("a|b\n# c"), "a\\|b \\# c");
    EXPECT_EQ(escapedMarkdown("<img src=x> ![a](b) @ann `c`"),
              "&lt;img src=x&gt; \\!\\[a\\](b) &#64;ann \\`c\\`");
    EXPECT_EQ(escapedMarkdown("- a"), "\\- a");
    EXPECT_EQ(escapedMarkdown("https://example.org"), "https&#58;//example.org");
    EXPECT_EQ(escapedMarkdown("\x1b[31mred\xff"), " \\[31mred?");
    EXPECT_EQ(escapedMarkdown(std::string(1000, 'x'), 10), "xxxxxxxxx…");
}

TEST(Markdown, AFenceIsLongerThanAnyInside) {
    EXPECT_EQ(fencedMarkdown("a"), "```text\na\n```\n");
    const std::string fenced = fencedMarkdown("`````\n# forged");
    EXPECT_THAT(fenced, StartsWith("``````text\n"));
    EXPECT_THAT(fenced, EndsWith("\n``````\n"));
    EXPECT_EQ(codeMarkdown("a`b"), "``a`b``");
    EXPECT_EQ(codeMarkdown("`a|\nb`"), "`` `a\\| b` ``");
}

TEST(WorkflowCommands, ATextStaysInItsPlace) {
    EXPECT_EQ(commandData("100%\n::error::x"), "100%25%0A::error::x");
    EXPECT_EQ(commandProperty("a,b:c\n"), "a%2Cb%3Ac%0A");
    EXPECT_EQ(commandData(std::string(5000, 'x')).size(), 999 + std::string("…").size());
}

TEST(WorkflowCommands, NobodyCanGuessTheWordThatStartsThemAgain) {
    const std::string first = withoutCommands("x"), second = withoutCommands("x");
    EXPECT_THAT(first, StartsWith("::stop-commands::end-"));
    EXPECT_NE(first, second);
    const std::string word = first.substr(17, first.find('\n') - 17);
    EXPECT_THAT(first, EndsWith("\n::" + word + "::\n"));
    EXPECT_THAT(second, Not(HasSubstr(word)));
}

}  // namespace
