#include <cg/Todo.h>

#include <gtest/gtest.h>

#include <glm/glm.hpp>

namespace {

// The record lives as long as the process, so this file has one test that takes each step in turn.
TEST(Todo, NotesEachIdOnceAndReturnsTheNeutralValue) {
    ASSERT_TRUE(cg::reachedTodos().empty());
    EXPECT_EQ(cg::todo<glm::mat3>("b"), glm::mat3(1.0f));
    EXPECT_EQ(cg::todo("a", 7), 7);
    cg::todo("c");
    cg::todo("b");
    EXPECT_EQ(cg::reachedTodos(), (std::vector<std::string>{"b", "a", "c"}));

    testing::internal::CaptureStderr();
    cg::announceTodos(true);
    cg::todo("a");
    cg::todo("d");
    cg::todo("d");
    cg::announceTodos(false);
    cg::todo("e");
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "TODO b: not implemented yet\nTODO a: not implemented yet\n"
              "TODO c: not implemented yet\nTODO d: not implemented yet\n");
}

}  // namespace
