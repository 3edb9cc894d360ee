#include "Toolchain.h"

#include <gtest/gtest.h>

#include "testing/Tree.h"

namespace {

using namespace grader;
using testing_help::Tree;

TEST(Toolchain, AKitIsAnotherWhenAnyOfItsFilesIs) {
    const Tree tree;
    tree.write("include/cg/Error.h", "struct Error;\n");
    tree.write("bin/runner", "1");
    const std::string before = fingerprintOf(tree.path());
    EXPECT_EQ(fingerprintOf(tree.path()), before);
    tree.write("include/cg/Error.h", "class Error ;\n");
    EXPECT_NE(fingerprintOf(tree.path()), before) << "an edit that keeps the size";
    const std::string edited = fingerprintOf(tree.path());
    tree.write("include/cg/more.h", "");
    EXPECT_NE(fingerprintOf(tree.path()), edited);
}

}  // namespace
