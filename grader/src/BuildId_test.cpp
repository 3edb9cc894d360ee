#include "BuildId.h"

#include <gtest/gtest.h>

#include "Error.h"
#include "Process.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing_help::Tree;

TEST(BuildId, IsWhatTheLinkerWrote) {
    const Tree tree;
    tree.write("a.c", "int main(void) { return 0; }\n");
    const auto link = [&](const std::string& id) {
        const std::string program = (tree / ("a" + id)).string();
        EXPECT_TRUE(run({"cc", (tree / "a.c").string(), "-o", program, "-Wl,--build-id=" + id}, 60)
                        .succeeded());
        return program;
    };
    EXPECT_EQ(identityOf(link("0xc0ffee")), "c0ffee");
    EXPECT_EQ(identityOf(link("sha1")).size(), 40u);
    const std::string without = link("none");
    EXPECT_EQ(identityOf(without), sha256(readFile(without)));
}

TEST(BuildId, OfOtherFilesIsAHash) {
    const Tree tree;
    for (const std::string text : {"", "#!/bin/sh\n", "\177ELF\2\1\1", "\177ELF"})
        EXPECT_EQ(identityOf(tree.write("file", text)), sha256(text));
    EXPECT_THROW(identityOf(tree / "missing"), Error);
}

}  // namespace
