// Users of jobs, and what is theirs. Most of it takes root.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "Sandbox.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing_help::Tree;

constexpr unsigned kSomeUser = 65123;

TEST(JobUsers, OfTwoJobsAreTwo) {
    const JobUser one, other;
    if (geteuid() != 0) {
        EXPECT_EQ(one.id(), geteuid());
        GTEST_SKIP() << "only root has others to give";
    }
    EXPECT_NE(one.id(), other.id());
    EXPECT_NE(one.id(), 0u);
}

TEST(JobUsers, NothingOfOneOutlivesItsJob) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root has others to give";
    pid_t survivor = 0;
    {
        const JobUser user;
        survivor = fork();
        if (survivor == 0) {
            setsid();
            if (setresuid(user.id(), user.id(), user.id()) == 0)
                sleep(1000);
            _exit(0);
        }
        usleep(50000);
        EXPECT_EQ(waitpid(survivor, nullptr, WNOHANG), 0) << "it should run";
    }
    int status = 0;
    EXPECT_EQ(waitpid(survivor, &status, 0), survivor);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

TEST(JobUsers, WhatAKilledGraderLeftIsGoneBeforeTheNextJob) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root has others to give";
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t grader = fork();
    if (grader == 0) {
        const JobUser user;
        const unsigned id = user.id();
        const pid_t job = fork();
        if (job == 0) {
            close_range(3, ~0U, 0);  // as a program that is started: the lock is none of its
            setsid();
            if (setresuid(id, id, id) == 0)
                sleep(1000);
            _exit(0);
        }
        const unsigned said[2] = {id, static_cast<unsigned>(job)};
        if (write(ready[1], said, sizeof said) == sizeof said)
            pause();
        _exit(1);
    }
    unsigned said[2] = {};
    ASSERT_EQ(read(ready[0], said, sizeof said), static_cast<ssize_t>(sizeof said));
    usleep(50000);
    kill(grader, SIGKILL);
    waitpid(grader, nullptr, 0);
    const auto lives = [&] {  // one that has ended may wait for its new parent to take note
        std::string state;
        std::getline(std::ifstream(fmt::format("/proc/{}/stat", said[1])), state);
        const auto name = state.rfind(')');
        return name != std::string::npos && state[name + 2] != 'Z';
    };
    EXPECT_TRUE(lives()) << "nobody has cleaned up yet";
    std::vector<std::unique_ptr<JobUser>> users;  // one of all is that one
    for (int i = 0; i < 500 && lives(); ++i)
        users.push_back(std::make_unique<JobUser>());
    for (int i = 0; i < 100 && lives(); ++i)
        usleep(10000);
    EXPECT_FALSE(lives());
}

TEST(ShareWithSandbox, GivesTheFolderAndAllInItToItsUser) {
    if (geteuid() != 0)
        GTEST_SKIP() << "only root gives files away";
    const Tree tree;
    const fs::path file = tree.write("stage/deep/file", "x");
    const auto statusOf = [](const fs::path& path) {
        struct stat status {};
        stat(path.c_str(), &status);
        return status;
    };
    shareWithSandbox(tree / "stage", kSomeUser, false);
    EXPECT_EQ(statusOf(file).st_uid, 0u) << "the sandbox's user reads it and cannot open it up";
    EXPECT_EQ(statusOf(file).st_gid, kSomeUser);
    EXPECT_EQ(statusOf(file).st_mode & 0777, 0640u);
    EXPECT_EQ(statusOf(tree / "stage").st_mode & 0777, 0750u);
    shareWithSandbox(tree / "stage", kSomeUser, true);
    EXPECT_EQ(statusOf(tree / "stage").st_uid, kSomeUser);
}

}  // namespace
