// What confined programs can and cannot do, tried for real where the machine allows it.

#include "Sandbox.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

#include "Error.h"
#include "Process.h"
#include "confine/FileRules.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::AllOf;
using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing_help::Tree;
using Command = std::vector<std::string>;

/// Whether `part` stands in `command` as it is, one word after the other.
bool follows(const Command& command, const Command& part) {
    return std::search(command.begin(), command.end(), part.begin(), part.end()) != command.end();
}

/// What root becomes in tests that start nothing.
constexpr unsigned kSomeUser = 65123;

Confinement someConfinement() {
    Confinement confinement;
    confinement.readable = {"/kit"};
    confinement.writable = {"/out"};
    confinement.workingFolder = "/kit/stage";
    confinement.limits = {7, 300, 20, 16, 40};
    confinement.user = kSomeUser;
    return confinement;
}

TEST(SandboxCommand, OfBubblewrapHidesEverythingThatIsNotNamed) {
    const Command command =
        makeBubblewrap("/kit/confine")->confine(someConfinement(), {"runner", "a b"});
    EXPECT_EQ(makeBubblewrap("/kit/confine")->name(), "bubblewrap");
    EXPECT_EQ(makeBubblewrap("/kit/confine")->weakness(), "");
    EXPECT_TRUE(follows(command, {"/kit/confine", "enter", "65123", "/"}));
    for (const char* flag : {"--unshare-all", "--die-with-parent", "--new-session", "--as-pid-1"})
        EXPECT_THAT(command, Contains(flag));
    EXPECT_THAT(command, Not(Contains("--share-net")));
    EXPECT_TRUE(follows(command, {"--cap-drop", "ALL"}));
    EXPECT_TRUE(follows(command, {"--tmpfs", "/tmp"}));
    EXPECT_TRUE(follows(command, {"--ro-bind", "/usr", "/usr"}));
    EXPECT_TRUE(follows(command, {"--ro-bind", "/kit", "/kit"}));
    EXPECT_TRUE(follows(command, {"--bind", "/out", "/out"}));
    EXPECT_TRUE(follows(command, {"--remount-ro", "/"}));
    EXPECT_TRUE(follows(command, {"--chdir", "/kit/stage"}));
    EXPECT_EQ(std::count(command.begin(), command.end(), "--bind"), 1) << "one folder is writable";
    EXPECT_TRUE(follows(command, {"runner", "a b"}));
    EXPECT_EQ(command.back(), "a b");
}

TEST(SandboxCommand, BothCarryTheLimits) {
    for (const auto& sandbox : {makeBubblewrap("/kit/confine"), makePlainProcess("/kit/confine")}) {
        const Command command = sandbox->confine(someConfinement(), {"runner"});
        const auto last = std::find(command.rbegin(), command.rend(), "/kit/confine");
        ASSERT_NE(last, command.rend());
        const Command after(last.base() - 1, command.end());
        for (const char* limit : {"cpu=7", "memory=300", "file=16", "files=40"})
            EXPECT_THAT(after, Contains(limit)) << sandbox->name();
        EXPECT_TRUE(follows(after, {"--", "runner"}));
    }
}

TEST(SandboxCommand, OfRootBecomesSomebodyElseFirst) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root can become another user";
    const Command first = {"/kit/confine", "enter", "65123"};
    for (const auto& sandbox : {makeBubblewrap("/kit/confine"), makePlainProcess("/kit/confine")}) {
        const Command command = sandbox->confine(someConfinement(), {"runner"});
        EXPECT_TRUE(std::equal(first.begin(), first.end(), command.begin())) << sandbox->name();
        EXPECT_THAT(command, Contains("processes=20"));
        Confinement asRoot = someConfinement();
        asRoot.user = 0;
        EXPECT_THROW(sandbox->confine(asRoot, {"runner"}), Error) << sandbox->name();
    }
}

TEST(SandboxCommand, ThePlainOneSaysWhatItDoesNotProtectFrom) {
    EXPECT_EQ(makePlainProcess("/kit/confine")->name(), "plain");
    EXPECT_THAT(makePlainProcess("/kit/confine")->weakness(),
                HasSubstr(geteuid() == 0 ? "as a user of its own" : "only code that you trust"));
}

/// The probe in a folder that the sandbox may read, and one that it may write.
class Confined : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        fs::create_directories(tree_ / "in");
        fs::create_directories(tree_ / "out");
        fs::copy_file(SANDBOX_PROBE, tree_ / "in/probe");
        fs::copy_file(CONFINE, tree_ / "in/confine");
        sandbox_ = std::string(GetParam()) == "plain" ? makePlainProcess(tree_ / "in/confine")
                                                      : makeBubblewrap(tree_ / "in/confine");
        shareWithSandbox(tree_ / "in", user_.id(), false);
        shareWithSandbox(tree_ / "out", user_.id(), true);
        fs::permissions(tree_ / "in/probe", fs::perms(0755));
        fs::permissions(tree_ / "in/confine", fs::perms(0755));
        confinement_.user = user_.id();
        confinement_.readable = {tree_ / "in"};
        confinement_.writable = {tree_ / "out"};
        confinement_.workingFolder = tree_ / "in";
        if (const auto tried = confined({"true"}); !tried.succeeded())
            GTEST_SKIP() << GetParam() << " does not run on this machine: " << tried.output;
    }
    bool isBubblewrap() const { return sandbox_->name() == "bubblewrap"; }
    ProcessResult confined(const Command& command, double seconds = 20) const {
        return run(sandbox_->confine(confinement_, command), seconds);
    }
    /// What the probe printed.
    std::string attempt(const std::string& what, const std::string& argument = "") const {
        return confined({(tree_ / "in/probe").string(), what, argument}).output;
    }

    Tree tree_;
    JobUser user_;
    std::unique_ptr<Sandbox> sandbox_;
    Confinement confinement_;
};

INSTANTIATE_TEST_SUITE_P(Sandbox, Confined, testing::Values("bubblewrap", "plain"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(Confined, RunsInItsWorkingFolderAndReadsAndWritesWhatIsNamed) {
    EXPECT_EQ(confined({"pwd"}).output, (tree_ / "in").string() + "\n");
    EXPECT_EQ(attempt("read", (tree_ / "in/probe").string()), "read: yes\n");
    EXPECT_EQ(attempt("write", (tree_ / "out").string()), "write: yes\n");
    EXPECT_TRUE(fs::exists(tree_ / "out/written"));
}

TEST_P(Confined, RootRunsItAsTheJobsUser) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root can become another user";
    const unsigned inside = isBubblewrap() ? 65534 : user_.id();
    EXPECT_EQ(attempt("user"),
              "uid " + std::to_string(inside) + " gid " + std::to_string(inside) + "\n");
    attempt("write", (tree_ / "out").string());
    struct stat status {};
    ASSERT_EQ(stat((tree_ / "out/written").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, user_.id()) << "seen from outside";
}

TEST_P(Confined, FilesThatOnlyRootMayReadStayUnread) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root can own such a file";
    writeFile(tree_ / "in/secret", "reference");
    fs::permissions(tree_ / "in/secret", fs::perms(0600));
    EXPECT_EQ(attempt("read", (tree_ / "in/secret").string()), "read: Permission denied\n");
}

TEST_P(Confined, WhatIsReadableIsNotWritable) {
    EXPECT_THAT(attempt("write", (tree_ / "in").string()),
                isBubblewrap() ? HasSubstr("Read-only file system")
                               : HasSubstr(geteuid() == 0 ? "Permission denied" : "write: "));
}

TEST_P(Confined, TheEnvironmentIsCleared) {
    setenv("SECRET_OF_THE_GRADER", "token", 1);
    confinement_.environment = {"LP_NUM_THREADS=0"};
    const std::string seen = attempt("environment");
    unsetenv("SECRET_OF_THE_GRADER");
    EXPECT_THAT(seen, Not(HasSubstr("SECRET_OF_THE_GRADER")));
    EXPECT_THAT(seen, AllOf(HasSubstr("PATH=/usr/bin:/bin\n"), HasSubstr("LANG=C.UTF-8\n"),
                            HasSubstr("LP_NUM_THREADS=0\n")));
}

TEST_P(Confined, DangerousSystemCallsAreRefused) {
    for (const char* call :
         {"unshare", "mount", "ptrace", "process_vm_readv", "keyctl", "bpf", "io_uring_setup",
          "userfaultfd", "perf_event_open", "clone-newuser", "setns", "personality"})
        EXPECT_EQ(attempt("call", call), std::string(call) + ": Operation not permitted\n");
    EXPECT_EQ(attempt("call", "clone3"), "clone3: Function not implemented\n");
    for (const char* family : {"unix", "inet", "inet6", "netlink", "packet", "vsock", "alg"})
        EXPECT_EQ(attempt("socket", family), std::string(family) + ": Permission denied\n");
}

TEST_P(Confined, TheLimitOfProcessesHolds) {
    const std::string seen = attempt("fork", "200");
    if (isBubblewrap() || geteuid() == 0) {
        EXPECT_THAT(seen, HasSubstr("failure: Resource temporarily unavailable"));
        int started = 200;
        ASSERT_EQ(std::sscanf(seen.c_str(), "started: %d", &started), 1) << seen;
        EXPECT_LE(started, confinement_.limits.processes);
        EXPECT_GT(started, 8) << "the runner needs some";
    }
}

TEST_P(Confined, TheLimitOfMemoryHolds) {
    confinement_.limits.memoryMib = 256;
    EXPECT_EQ(attempt("memory", "64"), "memory: yes\n");
    EXPECT_EQ(attempt("memory", "512"), "memory: Cannot allocate memory\n");
}

TEST_P(Confined, TheLimitOfFilesHolds) {
    confinement_.limits.fileMib = 2;
    EXPECT_EQ(attempt("large-file", (tree_ / "out").string()), "written: 2\n");
}

TEST_P(Confined, TheLimitOfCpuTimeHolds) {
    confinement_.limits.cpuSeconds = 1;
    const auto start = std::chrono::steady_clock::now();
    const ProcessResult ended = confined({(tree_ / "in/probe").string(), "spin"}, 20);
    EXPECT_FALSE(ended.succeeded());
    EXPECT_FALSE(ended.timedOut);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(15));
}

/// Processes whose command line is exactly these words, each ended by a zero byte.
int runningLike(const std::string& commandLine) {
    int found = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        std::ifstream file(entry.path() / "cmdline", std::ios::binary);
        found += std::string(std::istreambuf_iterator<char>(file), {}) == commandLine;
    }
    return found;
}

TEST_P(Confined, ATimeoutLeavesNothingRunning) {
    const std::string seconds = "77." + std::to_string(getpid());
    // A plain process that leaves its group gets away; in a namespace of its own there is no away.
    const std::string leaving = isBubblewrap() ? "setsid sleep " : "sleep ";
    const auto start = std::chrono::steady_clock::now();
    const auto ended = confined({"sh", "-c", leaving + seconds + " & sleep " + seconds}, 0.5);
    EXPECT_TRUE(ended.timedOut);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    const std::string commandLine = std::string("sleep") + '\0' + seconds + '\0';
    for (int i = 0; i < 100 && runningLike(commandLine) > 0; ++i)
        usleep(10000);
    EXPECT_EQ(runningLike(commandLine), 0);
}

TEST_P(Confined, FilesOfOthersAreNotOpened) {
    if (!sandbox_->hidesFiles())
        GTEST_SKIP() << "this kernel has no Landlock";
    const Tree other;
    other.write("solution.cpp", "solved");
    fs::permissions(other.path(), fs::perms(0755));
    fs::create_directory(other / "for-all");
    fs::permissions(other / "for-all", fs::perms(0777));
    for (const std::string& file : {(other / "solution.cpp").string(), std::string("/etc/passwd"),
                                    "/proc/self/root" + (other / "solution.cpp").string()})
        EXPECT_THAT(attempt("read", file), Not(HasSubstr("yes"))) << file;
    EXPECT_THAT(attempt("write", (other / "for-all").string()), Not(HasSubstr("yes")));
    EXPECT_EQ(attempt("read", "/usr/bin/env"), "read: yes\n") << "the system's own";
}

TEST(PlainProcess, LeavesNothingInTheTemporaryFoldersOfAll) {
    if (!confine::canHoldToFiles())
        GTEST_SKIP() << "this kernel has no Landlock";
    const Tree tree;
    const JobUser user;
    fs::create_directory(tree / "out");
    shareWithSandbox(tree / "out", user.id(), true);
    Confinement confinement;
    confinement.user = user.id();
    confinement.writable = {tree / "out"};
    confinement.workingFolder = tree / "out";
    const auto plain = makePlainProcess(CONFINE);
    const auto say = [&](const std::string& command) {
        return run(plain->confine(confinement, {"sh", "-c", command}), 20).output;
    };
    EXPECT_EQ(say("echo $TMPDIR"), (tree / "out").string() + "\n");
    for (const char* folder : {"/tmp", "/var/tmp", "/dev/shm", "/run/lock"})
        if (fs::exists(folder)) {
            EXPECT_THAT(say(fmt::format("echo x > {}/left-by-a-test", folder)),
                        HasSubstr("Permission denied"))
                << folder;
        }
}

TEST(PlainProcess, SignalsStayInside) {
    const Tree tree;
    Confinement confinement;
    confinement.user = 65000;
    confinement.readable = {tree.path()};
    confinement.workingFolder = "/";
    const pid_t other = fork();
    if (other == 0) {
        if (geteuid() == 0 && setresuid(65000, 65000, 65000) != 0)
            _exit(1);
        sleep(30);
        _exit(0);
    }
    const auto plain = makePlainProcess(CONFINE);
    const std::string said =
        run(plain->confine(confinement, {"sh", "-c", fmt::format("kill -TERM {}", other)}), 20)
            .output;
    const bool lives = waitpid(other, nullptr, WNOHANG) == 0;
    kill(other, SIGKILL);
    waitpid(other, nullptr, 0);
    if (syscall(SYS_landlock_create_ruleset, nullptr, 0, 1) < 6)
        GTEST_SKIP() << "this kernel's Landlock does not hold signals back (Linux 6.12 does)";
    EXPECT_TRUE(lives) << said;
    EXPECT_THAT(said, HasSubstr("not permitted"));
}

/// What only bubblewrap keeps from a program.
class Hidden : public Confined {};

INSTANTIATE_TEST_SUITE_P(Sandbox, Hidden, testing::Values("bubblewrap"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(Hidden, NothingElseIsVisible) {
    const Tree other;
    other.write("solution.cpp", "solved");
    fs::permissions(other.path(), fs::perms(0755));
    EXPECT_THAT(attempt("read", (other / "solution.cpp").string()), HasSubstr("No such file"));
    EXPECT_THAT(attempt("read", "/etc/passwd"), HasSubstr("No such file"));
    EXPECT_THAT(confined({"ls", "/"}).output, Not(ContainsRegex("(home|root|var|srv|mnt)\n")));
    EXPECT_THAT(attempt("write", "/"), HasSubstr("Read-only"));
}

TEST_P(Hidden, TmpIsItsOwn) {
    EXPECT_EQ(attempt("write", "/tmp"), "write: yes\n");
    EXPECT_FALSE(fs::exists("/tmp/written"));
    EXPECT_EQ(confined({"ls", "-A", "/tmp"}).output, tree_.path().filename().string() + "\n");
}

TEST_P(Hidden, MemoryThatLooksLikeFilesIsSmall) {
    for (const char* folder : {"/tmp", "/dev/shm"}) {
        EXPECT_EQ(attempt("write", folder), "write: yes\n") << folder;
        EXPECT_THAT(confined({"df", "-m", "--output=size", folder}).output, HasSubstr(" 64\n"));
    }
    EXPECT_FALSE(fs::exists("/dev/shm/written"));
    EXPECT_THAT(attempt("write", "/dev"), HasSubstr("Read-only"));
}

TEST_P(Hidden, OtherProcessesAreNotSeen) {
    const std::string seen = confined({"sh", "-c", "ls /proc | grep -c '^[0-9]'"}).output;
    EXPECT_LE(std::stoi(seen), 4) << "bwrap, sh, ls, grep and nothing else";
    EXPECT_GE(std::stoi(seen), 2);
}

TEST_P(Confined, WhatCompilesNothingSeesLibrariesAndTheProgramsItNames) {
    if (!sandbox_->hidesFiles())
        GTEST_SKIP() << "this kernel has no Landlock";
    confinement_.programs = {"sh"};
    EXPECT_EQ(confined({"sh", "-c", "echo said"}).output, "said\n");
    EXPECT_TRUE(confined({(tree_ / "in/probe").string(), "user"}).succeeded()) << "libraries stay";
    for (const char* program : {"g++", "ls", "git"})
        EXPECT_FALSE(confined({program, "--version"}).succeeded()) << program;
    for (const char* file :
         {"/usr/include/stdio.h", "/usr/bin/env", "/usr/share/common-licenses/GPL"})
        EXPECT_THAT(attempt("read", file), Not(HasSubstr("yes"))) << file;
    for (const char* folder : {"/usr/bin", "/usr/lib"})
        EXPECT_THAT(attempt("write", folder), Not(HasSubstr("yes"))) << folder;
    if (isBubblewrap()) {
        EXPECT_EQ(confined({"sh", "-c", "echo /usr/bin/*"}).output, "/usr/bin/sh\n");
    }
}

TEST_P(Confined, ThereIsNoNetwork) {
    const int server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof here;
    ASSERT_EQ(bind(server, reinterpret_cast<sockaddr*>(&here), size), 0);
    ASSERT_EQ(listen(server, 4), 0);
    ASSERT_EQ(getsockname(server, reinterpret_cast<sockaddr*>(&here), &size), 0);
    const std::string port = std::to_string(ntohs(here.sin_port));
    EXPECT_EQ(run({SANDBOX_PROBE, "connect", port}, 10).output, "connect: yes\n") << "outside";
    EXPECT_EQ(attempt("connect", port), "connect: Permission denied\n");
    close(server);
}

TEST(ChooseSandbox, TakesBubblewrapWhereItRuns) {
    const Tree tree;
    fs::copy_file(CONFINE, tree / "confine");
    for (const fs::path& each : {tree.path(), tree / "confine"})
        fs::permissions(each, fs::perms(0755));
    const auto chosen = chooseSandbox(tree / "confine");
    const JobUser user;
    Confinement nothing;
    nothing.workingFolder = "/";
    nothing.user = user.id();
    EXPECT_TRUE(run(chosen->confine(nothing, {"true"}), 10).succeeded());
    const bool works =
        run(makeBubblewrap(tree / "confine")->confine(nothing, {"true"}), 10).succeeded();
    EXPECT_EQ(chosen->name(), works ? "bubblewrap" : "plain");
}

/// In a process of its own: as an ordinary user where no sandbox can be started.
[[noreturn]] void chooseWithoutAny(SandboxWish wish) {
    if (geteuid() == 0 && setuid(kSomeUser) != 0)
        _exit(9);
    try {
        std::cerr << chooseSandbox("/nowhere/confine", wish)->name();
    } catch (const Error& error) {
        std::cerr << error.what();
    }
    _exit(0);
}

TEST(ChooseSandbox, RefusesStrangersWhereNothingHoldsThem) {
    const testing::ExitedWithCode ended(0);
    EXPECT_EXIT(chooseWithoutAny({}), ended, "plain");
    EXPECT_EXIT(chooseWithoutAny({.strangers = true}), ended, "insist with --no-sandbox");
    EXPECT_EXIT(chooseWithoutAny({.none = true, .strangers = true}), ended, "plain");
}

TEST(ChooseSandbox, RefusesToShowStrangersASecret) {
    for (const char* place : {"/usr/src/app", "/usr", "/lib/course/../course"})
        EXPECT_THAT(testing_help::whatOf<Error>([&] {
                        chooseSandbox(CONFINE, {.strangers = true, .secrets = {"/srv", place}});
                    }),
                    HasSubstr("where a submission's compiler may read"))
            << place;
}

TEST(RunsInCi, IsWhatTheVariableSays) {
    const char* before = std::getenv("CI");
    const std::string kept = before ? before : "";
    setenv("CI", "true", 1);
    EXPECT_TRUE(runsInCi());
    setenv("CI", "false", 1);
    EXPECT_FALSE(runsInCi());
    setenv("CI", "", 1);
    EXPECT_FALSE(runsInCi());
    setenv("CI", kept.c_str(), 1);
}

}  // namespace
