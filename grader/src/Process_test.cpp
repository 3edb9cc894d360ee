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

ProcessResult shell(const std::string& script, double seconds = 10, std::size_t limit = 1 << 20) {
    return run({"sh", "-c", script}, seconds, limit);
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

TEST(Process, OutputBeyondTheLimitEndsIt) {
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult result = shell("yes", 30, 1000);
    EXPECT_EQ(result.output.size(), 1000u);
    EXPECT_FALSE(result.succeeded());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Process, CpuTimeCountsChildrenThatEnded) {
    const double before = cpuSeconds();
    shell("i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done");
    EXPECT_GT(cpuSeconds(), before + 0.02);
}

}  // namespace
