// The judge's side of the wall, against runners that behave and runners that do not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "subject/Subject.h"
#include "testing/Tree.h"

namespace {

using namespace judge;
using protocol::Answer;
using protocol::Outcome;
using testing::ElementsAre;
using testing::HasSubstr;

std::unique_ptr<Subject> fake(const std::string& mode) {
    return startSubject({FAKE_RUNNER, mode});
}

Answer answerOf(const std::string& mode, std::uint32_t timeoutMs = 2000) {
    protocol::Request request;
    request.name = "turn";
    request.timeoutMs = timeoutMs;
    return fake(mode)->ask(request);
}

TEST(ProcessSubject, AnHonestRunnerGivesItsValueAndItsUnfilledRegions) {
    const auto subject = fake("honest");
    std::vector<std::string> todos;
    subject->onTodos = [&](const std::vector<std::string>& ids) { todos = ids; };
    EXPECT_EQ(subject->call<int>("turn", 1.0f), 42);
    EXPECT_THAT(todos, ElementsAre("rotation"));
    EXPECT_EQ(subject->call<int>("turn"), 42) << "one runner serves many requests";
}

TEST(ProcessSubject, WhatComesAfterAllPatienceIsNotAsked) {
    const auto subject = fake("honest");
    subject->patienceSeconds = 1e-9;
    EXPECT_EQ(subject->ask({}).outcome, Outcome::ok) << "the first takes all of it";
    const Answer late = subject->ask({});
    EXPECT_EQ(late.outcome, Outcome::faulty);
    EXPECT_THAT(late.detail, HasSubstr("more than all may take"));
}

TEST(ProcessSubject, AnotherNonceIsTampering) {
    const Answer answer = answerOf("wrong-nonce");
    EXPECT_EQ(answer.outcome, Outcome::tampered);
    EXPECT_TRUE(answer.payload.empty()) << "nothing of a forged answer is used";
}

TEST(ProcessSubject, BytesThatAreNoAnswerAreTampering) {
    EXPECT_EQ(answerOf("garbage").outcome, Outcome::tampered);
    EXPECT_EQ(answerOf("short-body").outcome, Outcome::tampered);
    EXPECT_EQ(answerOf("huge").outcome, Outcome::tampered);
}

TEST(ProcessSubject, AnAnswerTooManyIsNeverTakenForTheNext) {
    const auto subject = fake("answers-twice");
    EXPECT_EQ(subject->ask({}).outcome, Outcome::ok);
    EXPECT_EQ(subject->ask({}).outcome, Outcome::tampered);
}

TEST(ProcessSubject, ARunnerThatDiesIsTheGradersFaultAndItsErrorsAreKept) {
    const Answer answer = answerOf("dies");
    EXPECT_EQ(answer.outcome, Outcome::faulty);
    EXPECT_EQ(answer.detail, "the runner ended before it answered: libOSMesa is not here");
}

TEST(ProcessSubject, ARunnerThatCannotBeStartedIsNamed) {
    const Answer answer = startSubject({"/nonexistent/runner"})->ask({});
    EXPECT_EQ(answer.outcome, Outcome::faulty);
    EXPECT_THAT(answer.detail, HasSubstr("cannot start /nonexistent/runner: No such file"));
}

// The judge waits three seconds longer than the runner, which keeps the time itself.
TEST(ProcessSubject, ARunnerThatHangsIsLeftAlone) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(answerOf("hangs", 50).outcome, Outcome::timeout);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(ProcessSubject, ARunnerThatEndedIsStartedAgain) {
    const auto subject = fake("answers-once");
    EXPECT_EQ(subject->ask({}).outcome, Outcome::ok);
    EXPECT_EQ(subject->ask({}).outcome, Outcome::faulty);
    EXPECT_EQ(subject->ask({}).outcome, Outcome::ok);
}

TEST(ProcessSubject, TheRunnerEndsWithItsSubject) {
    int process = 0;
    {
        const auto subject = fake("process-id");
        process = subject->call<int>("turn");
        EXPECT_EQ(kill(process, 0), 0);
    }
    EXPECT_NE(kill(process, 0), 0);
}

/// A folder that looks like a cgroup in which the kernel steps in when a runner is started.
class SteppedIn : public testing::Test {
protected:
    /// What becomes of a request whose runner, in mode `mode`, finds these events.
    Answer answerOf(const std::string& mode, const std::string& file, const std::string& events) {
        const std::string write = "printf '" + events + "' > " + (cgroup_ / file).string();
        const auto subject =
            startSubject({"sh", "-c", write + "; exec " FAKE_RUNNER " " + mode + " $0"},
                         {cgroup_.path().string(), 300, 20});
        const Answer first = subject->ask({});
        EXPECT_EQ(subject->ask({}).outcome, mode == "honest" ? Outcome::ok : Outcome::faulty)
            << "the next request has no part in it";
        return first;
    }

    testing_help::Tree cgroup_;
};

TEST_F(SteppedIn, ARunnerThatWasKilledForItsMemoryIsNoFaultOfTheGraders) {
    const Answer answer = answerOf("dies", "memory.events", "max 9\\noom 1\\noom_kill 4\\n");
    EXPECT_EQ(answer.outcome, Outcome::memory);
    EXPECT_EQ(explain("turn", {}, answer).message,
              "turn asked for more memory than it may have (300 MiB)");
}

TEST_F(SteppedIn, AnAnswerCountsLessThanWhatTheKernelDid) {
    EXPECT_EQ(answerOf("honest", "memory.events", "oom 1\\noom_kill 1\\n").outcome,
              Outcome::memory);
}

TEST_F(SteppedIn, ForksThatWereRefusedAreTooManyProcesses) {
    const Answer answer = answerOf("honest", "pids.events", "max 3\\n");
    EXPECT_EQ(answer.outcome, Outcome::crash);
    EXPECT_EQ(explain("turn", {}, answer).message, "turn started more than 20 processes");
}

TEST_F(SteppedIn, AMachineWithoutMemoryIsNotTheSubmissionsFault) {
    EXPECT_EQ(answerOf("dies", "memory.events", "oom 0\\noom_kill 2\\n").outcome, Outcome::faulty);
}

TEST_F(SteppedIn, WhatHappensBetweenRequestsIsNotTheNextOnesDoing) {
    const auto subject =
        startSubject({FAKE_RUNNER, "process-id"}, {cgroup_.path().string(), 300, 20});
    const int before = subject->call<int>("turn");
    EXPECT_EQ(subject->call<int>("turn"), before);
    cgroup_.write("memory.events", "oom 1\noom_kill 1\n");
    EXPECT_NE(subject->call<int>("turn"), before) << "a new runner";
}

/// All the way down, in a sandbox whose memory for files is full when its first request comes.
TEST(ProcessSubject, AFolderThatIsFullIsCalledSoAndTheNextRequestGetsAnEmptyOne) {
    const testing_help::Tree tree;
    const std::string folder = tree.path().string();
    const std::vector<std::string> sandbox = {"bwrap",      "--unshare-all",
                                              "--as-pid-1", "--die-with-parent",
                                              "--ro-bind",  "/",
                                              "/",          "--proc",
                                              "/proc",      "--dev",
                                              "/dev",       "--bind",
                                              folder,       folder,
                                              "--size",     "1048576",
                                              "--tmpfs",    "/dev/shm",
                                              "--"};
    const auto within = [&](const std::vector<std::string>& more) {
        auto command = sandbox;
        command.insert(command.end(), more.begin(), more.end());
        return command;
    };
    if (startSubject(within({FAKE_RUNNER, "honest"}))->ask({}).outcome != Outcome::ok)
        GTEST_SKIP() << "bubblewrap does not work here";
    const std::string fillOnce =
        "mkdir " + folder + "/begun 2>&- && head -c 2M /dev/zero 2>&- > /dev/shm/file; exec \"$@\"";
    const auto subject =
        startSubject(within({"sh", "-c", fillOnce, "sh", RUNNER, GREEDY_SUBJECT, "/", "auto"}));
    protocol::Request request;
    request.name = "modest";
    request.arguments = protocol::encode(1);
    const Answer full = subject->ask(request);
    EXPECT_EQ(full.outcome, Outcome::output);
    EXPECT_EQ(explain("modest", request, full).message, "modest filled the 1 MiB of /dev/shm");
    EXPECT_EQ(subject->call<int>("modest", 1), 2);
}

TEST(SubjectCall, AFailureIsExplainedBeforeItIsThrown) {
    const auto subject = fake("crash");
    std::string told;
    subject->onFailure = [&](const Verdict& verdict) { told = verdict.message; };
    try {
        subject->call<int>("turn");
        ADD_FAILURE() << "no value, yet no failure";
    } catch (const SubjectFailure& failure) {
        EXPECT_EQ(failure.verdict.status, Status::crash);
        EXPECT_EQ(failure.verdict.message, told);
    }
    EXPECT_THAT(told, HasSubstr("turn crashed in turn, Camera.cpp:12 with SIGSEGV"));
}

TEST(SubjectCall, AValueOfAnotherTypeIsTheGradersFault) {
    try {
        fake("no-value")->call<int>("turn");
        ADD_FAILURE() << "a bool was taken for an int";
    } catch (const SubjectFailure& failure) {
        EXPECT_EQ(failure.verdict.status, Status::graderError);
        EXPECT_THAT(failure.verdict.message, HasSubstr("turn: expected int"));
    }
}

TEST(SubjectCall, AnEndlessLoopCostsOneTimeoutOnly) {
    const auto subject = fake("timeout-of-one");
    const auto messageOf = [&](const std::string& function) -> std::string {
        try {
            subject->call<int>(function);
        } catch (const SubjectFailure& failure) {
            EXPECT_EQ(failure.verdict.status, Status::timeout);
            return failure.what();
        }
        return "a value";
    };
    EXPECT_THAT(messageOf("slow"), HasSubstr("did not finish within 2 s"));
    EXPECT_THAT(messageOf("slow"), HasSubstr("not called again"));
    EXPECT_EQ(messageOf("quick"), "a value");
}

}  // namespace
