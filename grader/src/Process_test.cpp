#include "Process.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::HasSubstr;
using testing::StartsWith;
using testing_help::Tree;

ProcessResult shell(const std::string& script, double seconds = 10,
                    const RunOptions& options = {}) {
    return run({"sh", "-c", script}, seconds, options);
}

TEST(Process, GivesOutputErrorsAndExitCode) {
    const ProcessResult result = shell("echo out; echo err >&2; exit 7");
    EXPECT_EQ(result.exitCode, 7);
    EXPECT_EQ(result.signal, 0);
    EXPECT_FALSE(result.timedOut);
    EXPECT_FALSE(result.succeeded());
    EXPECT_EQ(result.output, "out\nerr\n");
    EXPECT_TRUE(shell("true").succeeded());
}

TEST(Process, ASignalIsNoExitCode) {
    const ProcessResult result = shell("kill -SEGV $$");
    EXPECT_EQ(result.signal, SIGSEGV);
    EXPECT_EQ(result.exitCode, -1);
    EXPECT_FALSE(result.succeeded());
}

TEST(Process, ArgumentsAreTakenToTheLetter) {
    EXPECT_EQ(run({"printf", "%s|", "a b", "$HOME", "*", ""}, 10).output, "a b|$HOME|*||");
}

TEST(Process, StandardInputIsEmpty) {
    EXPECT_EQ(shell("cat; echo done").output, "done\n");
}

TEST(Process, NoOtherDescriptorIsInherited) {
    const int ours = fcntl(1, F_DUPFD, 77);  // as a careless library would open it
    ASSERT_GE(ours, 77);
    const std::string seen = run({"ls", "/proc/self/fd"}, 10).output;
    close(ours);
    EXPECT_EQ(seen, "0\n1\n2\n3\n") << "3 is the folder that ls lists";
}

TEST(Process, ACommandThatIsMissingIsNamed) {
    const ProcessResult result = run({"/nonexistent/program"}, 10);
    EXPECT_EQ(result.exitCode, 127);
    EXPECT_THAT(result.output, StartsWith("cannot start /nonexistent/program: No such file"));
}

TEST(Process, ATimeoutKillsGrandchildrenToo) {
    const Tree tree;
    const std::string file = (tree / "pid").string();
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult result = shell("(sleep 60 & echo $! > " + file + "; wait) & wait", 0.3);
    EXPECT_TRUE(result.timedOut);
    EXPECT_FALSE(result.succeeded());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    const pid_t grandchild = std::stoi(readFile(file));
    for (int i = 0; i < 100 && kill(grandchild, 0) == 0; ++i) {
        // A dead process stays known until somebody has asked for its end.
        const std::string stat = "/proc/" + std::to_string(grandchild) + "/stat";
        if (fs::exists(stat) && readFile(stat).find(") Z ") != std::string::npos)
            return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_NE(kill(grandchild, 0), 0) << "the grandchild lives";
}

TEST(Process, OutputBeyondTheLimitIsDropped) {
    const ProcessResult result =
        shell("head -c 100000 /dev/zero; exit 3", 30, {.outputLimit = 1000});
    EXPECT_EQ(result.output, std::string(1000, '\0'));
    EXPECT_TRUE(result.cut);
    EXPECT_EQ(result.exitCode, 3) << "it ended by itself";
    EXPECT_FALSE(shell("head -c 1000 /dev/zero", 30, {.outputLimit = 1000}).cut);
}

TEST(Process, OutputBeyondTheLimitEndsItWhereThatIsWanted) {
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult result = shell("yes", 30, {.outputLimit = 1000, .endAtLimit = true});
    EXPECT_EQ(result.output.size(), 1000u);
    EXPECT_TRUE(result.cut);
    EXPECT_FALSE(result.succeeded());
    EXPECT_FALSE(result.timedOut);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Process, WhatClosesItsOutputIsWaitedForNoLonger) {
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult result = shell("exec > /dev/null 2>&1; sleep 60", 0.3);
    EXPECT_TRUE(result.timedOut);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_EQ(shell("exec > /dev/null 2>&1; sleep 0.2; exit 5").exitCode, 5);
}

TEST(Process, ErrorsCanBeKeptApart) {
    const ProcessResult result = shell("echo out; echo err >&2", 10, {.errorsApart = true});
    EXPECT_EQ(result.output, "out\n");
    EXPECT_EQ(result.errors, "err\n");
}

TEST(Process, CpuTimeCountsChildrenThatEnded) {
    const double before = cpuSeconds();
    shell("i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done");
    EXPECT_GT(cpuSeconds(), before + 0.02);
}

}  // namespace
