#include "watch/GradingProcess.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "Error.h"
#include "Process.h"

namespace {

using namespace grader;

/// All messages until the work has ended, or until there is one when `onlyFirst`.
std::vector<Json> messagesOf(GradingProcess& process, bool onlyFirst = false) {
    std::vector<Json> all;
    while (!process.ended() && !(onlyFirst && !all.empty())) {
        pollfd waiting{process.descriptor(), POLLIN, 0};
        EXPECT_EQ(poll(&waiting, 1, 20000), 1);
        for (Json& each : process.take())
            all.push_back(std::move(each));
    }
    return all;
}

bool isAlive(pid_t pid) {
    std::ifstream status(fmt::format("/proc/{}/stat", pid));
    std::string word;
    return status >> word >> word >> word && word != "Z";
}

TEST(GradingProcess, TellsMessagesAndEnds) {
    int here = 1;
    GradingProcess process([&](const GradingProcess::Tell& tell) {
        here = 2;
        tell({{"number", here}});
        tell({{"text", "two\nlines"}, {"much", std::string(300000, 'x')}});
    });
    const auto messages = messagesOf(process);
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_EQ(messages[0].at("number"), 2);
    EXPECT_EQ(messages[1].at("text"), "two\nlines");
    EXPECT_EQ(process.failure(), "");
    EXPECT_EQ(here, 1) << "it is another process";
}

TEST(GradingProcess, WhatIsThrownIsAFailure) {
    GradingProcess process([](const GradingProcess::Tell& tell) {
        tell({{"number", 1}});
        throw Error("no references");
    });
    EXPECT_EQ(messagesOf(process).size(), 1u);
    EXPECT_EQ(process.failure(), "no references");
}

TEST(GradingProcess, AnEndFromOutsideIsAFailure) {
    GradingProcess process([](const GradingProcess::Tell&) { raise(SIGKILL); });
    EXPECT_TRUE(messagesOf(process).empty());
    EXPECT_NE(process.failure().find("signal 9"), std::string::npos) << process.failure();
}

TEST(GradingProcess, AbandonedItLeavesNeitherChildrenNorFiles) {
    pid_t grandchild = 0, orphan = 0;
    fs::path folder;
    {
        GradingProcess process([](const GradingProcess::Tell& tell) {
            const WorkFolder work;
            const pid_t child = fork();
            if (child == 0) {
                setsid();
                const pid_t below = fork();
                if (below > 0)
                    tell({{"grandchild", getpid()},
                          {"orphan", below},
                          {"folder", work.path().string()}});
                for (;;)
                    pause();
            }
            for (;;)
                pause();
        });
        const auto messages = messagesOf(process, true);
        ASSERT_EQ(messages.size(), 1u);
        grandchild = messages[0].at("grandchild");
        orphan = messages[0].at("orphan");
        folder = messages[0].at("folder").get<std::string>();
        EXPECT_TRUE(isAlive(grandchild));
        EXPECT_TRUE(isAlive(orphan));
        EXPECT_TRUE(fs::exists(folder));
    }
    EXPECT_FALSE(isAlive(grandchild));
    EXPECT_FALSE(isAlive(orphan));
    EXPECT_FALSE(fs::exists(folder));
}

TEST(GradingProcess, OtherChildrenOfTheProgramStayAlive) {
    const pid_t browser = fork();
    if (browser == 0) {
        for (;;)
            pause();
    }
    {
        const GradingProcess process([](const GradingProcess::Tell&) { pause(); });
    }
    EXPECT_TRUE(isAlive(browser));
    kill(browser, SIGKILL);
    waitpid(browser, nullptr, 0);
}

}  // namespace
