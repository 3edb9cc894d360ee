#pragma once

#include <cg/OsMesaContext.h>
#include <cg/gl.h>

#include <gtest/gtest.h>

#include <string>

namespace cg {

/// For tests: a fixture with a current context in memory, 64 x 48, that must end without GL errors.
class GlTest : public ::testing::Test {
protected:
    void TearDown() override {
        if (context) {
            context->makeCurrent();
            EXPECT_EQ(context->errors(), "");
        }
    }

    std::unique_ptr<Context> context = createOsMesaContext(64, 48);
};

/// Text of the exception of type `Failure` that `action` throws; a test failure when it does not.
template <class Failure, class Action>
std::string messageOf(Action action) {
    try {
        action();
    } catch (const Failure& failure) {
        return failure.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return "";
}

}  // namespace cg
