// Where a grader may make cgroups, told from folders that look like those of a machine; then what
// cgroups do, for real where this machine has them.

#include "Cgroup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>

#include "Error.h"
#include "Process.h"
#include "Sandbox.h"
#include "subject/Subject.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kSelf = std::to_string(getpid());

/// /proc and /sys of a machine. Files hold what the kernel would say; they take any value, and no
/// cgroup can be removed that has one.
class Machine {
public:
    Machine() { mount("/", "/sys/fs/cgroup", "sys/fs/cgroup"); }

    /// `cgroup` is what can be seen in the folder `top`, which mountinfo calls `point`.
    void mount(const std::string& cgroup, const std::string& point, const std::string& top) {
        tree_.write("proc/self/mountinfo",
                    "22 27 0:21 / /proc rw,relatime - proc proc rw\n"
                    "33 23 0:28 " +
                        cgroup + " " + point + " rw,relatime shared:9 - cgroup2 cgroup2 rw\n");
        top_ = top;
        this->cgroup("", "");
    }
    void weAreIn(const std::string& cgroup) {
        tree_.write("proc/self/cgroup", "4:memory:/elsewhere\n0::" + cgroup + "\n");
    }
    void process(const std::string& id, const std::string& parent) {
        tree_.write("proc/" + id + "/status", "Name:\tsh\nPPid:\t" + parent + "\n");
    }

    /// `handsDown`: its children have the controllers.
    void cgroup(const std::string& path, const std::string& processes, bool handsDown = false,
                const std::string& controllers = "cpu memory pids") {
        const std::string folder = (top_ / path).string();
        if (!path.empty())
            tree_.write(folder + "/cgroup.type", "domain\n");
        tree_.write(folder + "/cgroup.controllers", controllers + "\n");
        tree_.write(folder + "/cgroup.subtree_control", handsDown ? "memory pids\n" : "");
        tree_.write(folder + "/cgroup.procs", processes);
    }
    void memoryLimit(const std::string& path, const std::string& limit) {
        tree_.write((top_ / path / "memory.max").string(), limit + "\n");
    }

    fs::path at(const std::string& path) const {
        return path.empty() ? tree_.path() / top_ : tree_.path() / top_ / path;
    }
    std::string read(const std::string& path) const { return readFile(at(path)); }
    const fs::path& root() const { return tree_.path(); }

private:
    testing_help::Tree tree_;
    fs::path top_;
};

/// The place that was taken; why none was, otherwise.
std::string placeOf(const Machine& machine) {
    const CgroupHome home(machine.root());
    EXPECT_EQ(home.folder().empty(), !home.found().empty());
    EXPECT_EQ(home.folder().empty(), !home.remedy().empty());
    return home.folder().empty() ? home.found() : home.folder().parent_path().string();
}

TEST(CgroupHome, InACgroupOfItsOwnTheGraderMovesToALeaf) {
    Machine machine;
    machine.cgroup("user/run.scope", kSelf + "\n");
    machine.weAreIn("/user/run.scope");
    EXPECT_EQ(placeOf(machine), machine.at("user/run.scope"));
    EXPECT_EQ(machine.read("user/run.scope/graders/cgroup.procs"), kSelf);
    EXPECT_EQ(machine.read("user/run.scope/cgroup.subtree_control"), "+memory +pids");
}

TEST(CgroupHome, WhatTheGraderStartedMovesWithIt) {
    Machine machine;
    machine.cgroup("run.scope", kSelf + "\n4711\n");
    machine.process("4711", "4710");
    machine.process("4710", kSelf);
    machine.weAreIn("/run.scope");
    EXPECT_EQ(placeOf(machine), machine.at("run.scope"));
    EXPECT_EQ(machine.read("run.scope/graders/cgroup.procs"), "4711");
}

TEST(CgroupHome, WhereOthersAreNobodyMoves) {
    Machine machine;
    machine.cgroup("", "", true);
    machine.cgroup("session.scope", "812\n" + kSelf + "\n");
    machine.process("812", "1");
    machine.process(kSelf, "812");
    machine.weAreIn("/session.scope");
    EXPECT_EQ(placeOf(machine), machine.at("")) << "the next one up that hands controllers down";
    EXPECT_FALSE(fs::exists(machine.at("session.scope/graders")));
    EXPECT_EQ(machine.read("session.scope/cgroup.subtree_control"), "");
}

TEST(CgroupHome, ALimitOfMemoryIsNotEscapedFrom) {
    Machine machine;
    machine.cgroup("", "", true);
    machine.cgroup("service", "812\n" + kSelf + "\n");
    machine.weAreIn("/service");
    machine.memoryLimit("service", "max");
    EXPECT_EQ(placeOf(machine), machine.at(""));
    machine.memoryLimit("service", "4294967296");
    EXPECT_THAT(placeOf(machine),
                testing::AllOf(HasSubstr("has processes of others"),
                               HasSubstr("has a limit of memory, and is not left")));
}

TEST(CgroupHome, InAContainerTheShellThatStartedItMovesToo) {
    Machine machine;
    machine.cgroup("", "1\n" + kSelf + "\n");
    fs::copy_file(machine.at("cgroup.procs"), machine.at("cgroup.type"));
    machine.process(kSelf, "1");
    machine.weAreIn("/");
    EXPECT_EQ(placeOf(machine), machine.at(""));
    EXPECT_TRUE(fs::exists(machine.at("graders")));
}

TEST(CgroupHome, InAContainerWithProcessesOfOthersThereIsNone) {
    Machine machine;
    machine.cgroup("", "1\n7\n" + kSelf + "\n");
    fs::copy_file(machine.at("cgroup.procs"), machine.at("cgroup.type"));
    machine.process(kSelf, "1");
    machine.process("7", "1");
    machine.weAreIn("/");
    EXPECT_THAT(placeOf(machine), HasSubstr("has processes of others"));
    EXPECT_FALSE(fs::exists(machine.at("graders")));
}

TEST(CgroupHome, TheNextGraderInALeafGoesUp) {
    Machine machine;
    machine.cgroup("run.scope", "", true);
    machine.cgroup("run.scope/graders", kSelf + "\n");
    machine.weAreIn("/run.scope/graders");
    EXPECT_EQ(placeOf(machine), machine.at("run.scope"));
}

TEST(CgroupHome, TheRootOfAllNeedsNoLeaf) {
    Machine machine;
    machine.cgroup("", "1\n2\n" + kSelf + "\n");
    machine.weAreIn("/");
    EXPECT_EQ(placeOf(machine), machine.at(""));
    EXPECT_FALSE(fs::exists(machine.at("graders")));
}

TEST(CgroupHome, ControllersThatVersion1HasAreMissed) {
    Machine machine;
    machine.cgroup("", "", false, "hugetlb");
    machine.weAreIn("/");
    EXPECT_THAT(placeOf(machine), HasSubstr("has no controllers of memory and pids"));
    EXPECT_THAT(CgroupHome(machine.root()).remedy(), HasSubstr("unified_cgroup_hierarchy"));
}

TEST(CgroupHome, NoMountAndNoMembershipAreNoHome) {
    Machine machine;
    machine.weAreIn("/../neighbour");
    EXPECT_THAT(placeOf(machine), HasSubstr("this process is in none"));
    machine.weAreIn("/");
    fs::remove(machine.at("cgroup.controllers"));
    EXPECT_THAT(placeOf(machine), HasSubstr("no cgroup v2 is mounted")) << "an empty folder";
    EXPECT_THAT(CgroupHome(machine.root() / "nowhere").found(), HasSubstr("no cgroup v2"));
}

TEST(CgroupHome, AMountOfAPartIsFollowed) {
    Machine machine;
    machine.mount("/docker/one", "/sys/fs/my\\040cgroup", "sys/fs/my cgroup");
    machine.cgroup("inner", kSelf + "\n");
    machine.weAreIn("/docker/one/inner");
    EXPECT_EQ(placeOf(machine), machine.at("inner"));
    machine.weAreIn("/docker/other");
    EXPECT_THAT(placeOf(machine), HasSubstr("no cgroup v2 is mounted"));
}

/// In a process of its own, as an ordinary user.
[[noreturn]] void lookAsSomebody(const fs::path& root) {
    if (geteuid() == 0 && setuid(65123) != 0)
        _exit(9);
    std::cerr << CgroupHome(root).found();
    _exit(0);
}

TEST(CgroupHome, WhatCannotBeWrittenToIsLeftAlone) {
    Machine machine;
    machine.cgroup("session.scope", "1\n");
    machine.weAreIn("/session.scope");
    fs::permissions(machine.at("session.scope"), fs::perms(0555));
    fs::permissions(machine.root(), fs::perms(0755));
    EXPECT_EXIT(lookAsSomebody(machine.root()), testing::ExitedWithCode(0),
                "session.scope is not ours to write to");
    fs::permissions(machine.at("session.scope"), fs::perms(0755));
}

TEST(CgroupHome, WhatAKilledGraderLeftIsRemovedAndWhatALivingOneHasIsNot) {
    Machine machine;
    machine.cgroup("", "");
    machine.weAreIn("/");
    fs::create_directories(machine.at("course-killed/1"));
    fs::create_directories(machine.at("course-living/1"));
    fs::create_directories(machine.at("others"));
    const int lock = open(machine.at("course-living").c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(flock(lock, LOCK_EX), 0);
    EXPECT_EQ(placeOf(machine), machine.at(""));
    EXPECT_FALSE(fs::exists(machine.at("course-killed")));
    EXPECT_TRUE(fs::exists(machine.at("course-living/1")));
    EXPECT_TRUE(fs::exists(machine.at("others")));
    close(lock);
}

TEST(Cgroup, HasTheLimitsThatItWasGiven) {
    Machine machine;
    machine.cgroup("", "");
    machine.weAreIn("/");
    const CgroupHome home(machine.root());
    const Cgroup one({300, 20}, home), other({.memoryMib = 9, .endTogether = false}, home);
    EXPECT_EQ(readFile(one.folder() / "memory.max"), "300M");
    EXPECT_EQ(readFile(one.folder() / "memory.swap.max"), "0");
    EXPECT_EQ(readFile(one.folder() / "memory.oom.group"), "1");
    EXPECT_EQ(readFile(one.folder() / "pids.max"), "20");
    EXPECT_NE(one.folder(), other.folder());
    EXPECT_EQ(readFile(other.folder() / "memory.max"), "9M");
    EXPECT_FALSE(fs::exists(other.folder() / "memory.oom.group"));
    EXPECT_FALSE(fs::exists(other.folder() / "pids.max"));
}

TEST(Cgroup, ThatCannotBeMadeInAHomeIsAFaultOfTheGraders) {
    Machine machine;
    machine.cgroup("", "");
    machine.weAreIn("/");
    const CgroupHome home(machine.root());
    fs::remove_all(home.folder());
    EXPECT_THAT(testing_help::whatOf<Error>([&] {
                    Cgroup({300, 20}, home);
                }),
                testing::AllOf(HasSubstr(home.folder().string()), HasSubstr("cannot be made")));
}

TEST(Cgroup, WithoutAHomeIsNone) {
    const CgroupHome none("/nowhere");
    EXPECT_EQ(Cgroup({300, 20}, none).folder(), "");
}

// ---- The real thing

class RealCgroup : public testing::Test {
protected:
    void SetUp() override {
#ifdef __SANITIZE_ADDRESS__
        GTEST_SKIP() << "a sanitizer takes more memory than these cgroups have";
#endif
        if (CgroupHome::ours().folder().empty())
            GTEST_SKIP() << "no cgroups here: " << CgroupHome::ours().found();
    }
    /// The command as a sandbox's first step starts it in there.
    static std::vector<std::string> inside(const Cgroup& cgroup, std::vector<std::string> command) {
        static const JobUser user;
        std::vector<std::string> all = {CONFINE,
                                        "enter",
                                        std::to_string(user.id()),
                                        "/",
                                        cgroup.folder().string(),
                                        "PATH=/usr/bin:/bin",
                                        "--"};
        all.insert(all.end(), command.begin(), command.end());
        return all;
    }
};

/// For a shell, which ends once there is a process outside of its group that runs on.
std::string leaveBehind(const std::string& seconds) {
    return "{ setsid sh -c 'echo; exec sleep " + seconds + " > /dev/null 2>&1' & } | read line";
}

TEST_F(RealCgroup, TheProgramRunsInIt) {
    const Cgroup cgroup({64, 8});
    const auto ran = run(inside(cgroup, {"cat", "/proc/self/cgroup"}), 20);
    EXPECT_THAT(ran.output, HasSubstr("/" + cgroup.folder().parent_path().filename().string() +
                                      "/" + cgroup.folder().filename().string() + "\n"));
}

TEST_F(RealCgroup, MemoryInManyProcessesEndsThemAll) {
    const Cgroup cgroup({64, 20});
    const auto modest = run(inside(cgroup, {SANDBOX_PROBE, "memory", "32"}), 20);
    EXPECT_EQ(modest.output, "memory: yes\n");
    EXPECT_EQ(judge::interventionsIn(cgroup.folder()).memory, 0u);
    const auto greedy = run(inside(cgroup, {SANDBOX_PROBE, "memory-in-many", "128"}), 30);
    EXPECT_EQ(greedy.signal, SIGKILL);
    EXPECT_FALSE(greedy.timedOut);
    EXPECT_GT(judge::interventionsIn(cgroup.folder()).memory, 0u);
}

TEST_F(RealCgroup, ProcessesTooManyAreRefused) {
    const Cgroup cgroup({64, 8});
    EXPECT_THAT(run(inside(cgroup, {SANDBOX_PROBE, "fork", "50"}), 20).output,
                StartsWith("started: 7\nfailure: Resource temporarily unavailable"));
    EXPECT_GT(judge::interventionsIn(cgroup.folder()).processes, 0u);
}

TEST_F(RealCgroup, AtTheEndNothingIsLeftInIt) {
    fs::path folder;
    {
        const Cgroup cgroup({64, 8});
        folder = cgroup.folder();
        run(inside(cgroup, {"sh", "-c", leaveBehind("78")}), 20);
        EXPECT_NE(readFile(folder / "cgroup.procs"), "") << "it runs on";
    }
    EXPECT_FALSE(fs::exists(folder));
}

TEST_F(RealCgroup, ARunnerThatTakesTooMuchIsCalledSoAndTheNextRequestGetsANewOne) {
    const Cgroup cgroup({64, 8});
    const auto answerOf = [&](const std::string& mode) {
        return judge::startSubject(inside(cgroup, {FAKE_RUNNER, mode}),
                                   {cgroup.folder().string(), 24, 8})
            ->ask({});
    };
    EXPECT_EQ(answerOf("honest").outcome, protocol::Outcome::ok);
    const auto answer = answerOf("eats");
    EXPECT_EQ(answer.outcome, protocol::Outcome::memory);
    EXPECT_EQ(answer.detail, "24 MiB");
}

/// All the way: bubblewrap, the runner in it, the child that loads the subject. There is no other
/// limit of memory, so nothing but the kernel ends it.
TEST_F(RealCgroup, ASubmissionThatTakesTooMuchCostsItsOwnRequestOnly) {
    const testing_help::Tree tree;
    fs::create_directories(tree / "in");
    for (const char* each : {RUNNER, CONFINE, GREEDY_SUBJECT})
        fs::copy_file(each, tree / "in" / fs::path(each).filename());
    const auto at = [&](const char* file) { return tree / "in" / fs::path(file).filename(); };
    const JobUser user;
    shareWithSandbox(tree / "in", user.id(), false);
    for (const char* each : {RUNNER, CONFINE})
        fs::permissions(at(each), fs::perms(0755));
    const Cgroup cgroup({160, 60});
    Confinement confinement;
    confinement.readable = {tree / "in"};
    confinement.workingFolder = tree / "in";
    confinement.user = user.id();
    confinement.cgroup = cgroup.folder();
    confinement.limits.memoryMib = 0;
    const auto subject = judge::startSubject(
        chooseSandbox(at(CONFINE))
            ->confine(confinement, {at(RUNNER), at(GREEDY_SUBJECT), "/", "auto"}),
        {cgroup.folder().string(), 40, 50});
    subject->callTimeoutMs = 20000;
    EXPECT_EQ(subject->call<int>("modest", 1), 2);
    EXPECT_EQ(testing_help::whatOf<judge::SubjectFailure>([&] { subject->call<int>("eat", 1); }),
              "eat asked for more memory than it may have (40 MiB)");
    EXPECT_EQ(subject->call<int>("modest", 1), 2);
}

TEST_F(RealCgroup, WhatAKilledGraderLeftIsRemovedWithAllThatRunsInIt) {
    int report[2];
    ASSERT_EQ(pipe(report), 0);
    const pid_t killed = fork();
    if (killed == 0) {  // a grader whose program runs on
        const CgroupHome home;
        const Cgroup cgroup({64, 8}, home);
        run(inside(cgroup, {"sh", "-c", leaveBehind("79")}), 20);
        dprintf(report[1], "%s", cgroup.folder().c_str());
        raise(SIGKILL);
    }
    close(report[1]);
    std::string folder(4096, '\0');
    folder.resize(
        static_cast<std::size_t>(std::max(read(report[0], folder.data(), 4096), ssize_t(0))));
    close(report[0]);
    waitpid(killed, nullptr, 0);
    ASSERT_NE(readFile(fs::path(folder) / "cgroup.procs"), "");
    const CgroupHome next;
    EXPECT_FALSE(fs::exists(fs::path(folder).parent_path()));
}

}  // namespace
