#include "TimeBox.h"

#include <gtest/gtest.h>

#include "Error.h"
#include "Process.h"

namespace {

using namespace grader;

double secondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(TimeBox, EndsACommandThatHasTimeLeftOfItsOwn) {
    const TimeBox box(0.2);
    EXPECT_TRUE(run({"true"}, 10).succeeded());
    EXPECT_LT(secondsOf([] { EXPECT_THROW(run({"sleep", "30"}, 30), Error); }), 10);
    EXPECT_THROW(TimeBox::check(), Error);
    EXPECT_THROW(run({"true"}, 10), Error) << "nothing is begun any more";
}

TEST(TimeBox, HoldsForWhatRunsBesideAndForNobodyElse) {
    {
        const TimeBox box(0.2);
        auto beside = alongside([] { return run({"sleep", "30"}, 30); });
        auto elsewhere = std::async(std::launch::async, [] { return run({"sleep", "0.5"}, 30); });
        EXPECT_LT(secondsOf([&] { EXPECT_THROW(beside.get(), Error); }), 10);
        EXPECT_TRUE(elsewhere.get().succeeded());
    }
    EXPECT_FALSE(TimeBox::isOver());
    EXPECT_TRUE(run({"true"}, 10).succeeded());
}

TEST(TimeBox, OfTwoTheShorterCounts) {
    const TimeBox outer(0.0);
    {
        const TimeBox inner(100.0);
        EXPECT_TRUE(TimeBox::isOver());
    }
    EXPECT_TRUE(TimeBox::isOver());
}

TEST(TimeBox, ACommandsOwnTimeIsStillItsOwn) {
    const TimeBox box(100.0);
    EXPECT_TRUE(run({"sleep", "30"}, 0.1).timedOut);
}

}  // namespace
