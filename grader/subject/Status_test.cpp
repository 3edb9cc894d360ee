#include "subject/Status.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace {

using namespace judge;
using protocol::Outcome;
using testing::HasSubstr;

Verdict explained(Outcome outcome, int code = 0, const std::string& detail = "") {
    protocol::Answer answer;
    answer.outcome = outcome;
    answer.code = code;
    answer.detail = detail;
    protocol::Request request;
    request.timeoutMs = 2500;
    request.outputBytes = 64 * 1024;
    return explain("turn", request, answer);
}

TEST(StatusWords, ComeBackAsTheyWere) {
    for (const Status each :
         {Status::pass, Status::partial, Status::fail, Status::notImplemented, Status::skipped,
          Status::pending, Status::buildError, Status::crash, Status::timeout, Status::memory,
          Status::output, Status::tampered, Status::graderError})
        EXPECT_EQ(statusFromString(toString(each)), each) << toString(each);
    EXPECT_STREQ(toString(Status::notImplemented), "not_implemented");
    EXPECT_STREQ(toString(Status::buildError), "build_error");
    EXPECT_STREQ(toString(Status::graderError), "grader_error");
    EXPECT_THROW(statusFromString("passed"), std::invalid_argument);
}

TEST(Explain, AMissingFunctionIsNotImplemented) {
    const Verdict verdict =
        explained(Outcome::missing, 0, "rotation is declared but nowhere defined");
    EXPECT_EQ(verdict.status, Status::notImplemented);
    EXPECT_EQ(verdict.message, "rotation is declared but nowhere defined");
}

TEST(Explain, AnException) {
    const Verdict verdict = explained(Outcome::exception, 0, "no axis");
    EXPECT_EQ(verdict.status, Status::crash);
    EXPECT_EQ(verdict.message, "turn threw an exception: no axis");
}

TEST(Explain, AnExceptionsTextIsCutBetweenCharacters) {
    std::string text = "x";
    for (int i = 0; i < 300; ++i)
        text += "é";
    const std::string message = explained(Outcome::exception, 0, text).message;
    EXPECT_LT(message.size(), 450u);
    EXPECT_TRUE(message.ends_with("é…")) << message;
}

TEST(Explain, ACrashNamesTheSignalAndThePlace) {
    const Verdict verdict = explained(Outcome::crash, SIGSEGV, "Camera::rotateUp, Camera.cpp:12");
    EXPECT_EQ(verdict.status, Status::crash);
    EXPECT_THAT(verdict.message, HasSubstr("turn crashed in Camera::rotateUp, Camera.cpp:12 with "
                                           "SIGSEGV"));
}

TEST(Explain, ACrashAtAnUnknownPlace) {
    EXPECT_THAT(explained(Outcome::crash, SIGFPE).message, HasSubstr("turn crashed with SIGFPE"));
    EXPECT_THAT(explained(Outcome::crash, SIGABRT).message, HasSubstr("SIGABRT"));
    EXPECT_THAT(explained(Outcome::crash, SIGILL).message, HasSubstr("SIGILL"));
    EXPECT_THAT(explained(Outcome::crash, SIGBUS).message, HasSubstr("SIGBUS"));
    EXPECT_THAT(explained(Outcome::crash, SIGKILL).message, HasSubstr("SIGKILL"));
    EXPECT_THAT(explained(Outcome::crash, SIGUSR1).message, HasSubstr("signal 10"));
}

TEST(Explain, LeavingWithSuccessIsTamperingAndWithFailureACrash) {
    EXPECT_EQ(explained(Outcome::exited, 0).status, Status::tampered);
    EXPECT_THAT(explained(Outcome::exited, 0).message, HasSubstr("exit status 0"));
    EXPECT_EQ(explained(Outcome::exited, 3).status, Status::crash);
    EXPECT_THAT(explained(Outcome::exited, 3).message, HasSubstr("exit status 3"));
}

TEST(Explain, LimitsAreNamed) {
    EXPECT_EQ(explained(Outcome::timeout).status, Status::timeout);
    EXPECT_THAT(explained(Outcome::timeout).message, HasSubstr("within 2.5 s"));
    EXPECT_EQ(explained(Outcome::timeout, 0, "used up the 60 s of processor time").message,
              "turn used up the 60 s of processor time");
    const Verdict memory = explained(Outcome::memory, 0, "1024 MiB");
    EXPECT_EQ(memory.status, Status::memory);
    EXPECT_THAT(memory.message, HasSubstr("more memory than it may have (1024 MiB)"));
    EXPECT_EQ(explained(Outcome::output).status, Status::output);
    EXPECT_THAT(explained(Outcome::output).message, HasSubstr("more than 64 KiB"));
    const Verdict file = explained(Outcome::output, 0, "wrote a file larger than 256 MiB");
    EXPECT_EQ(file.message, "turn wrote a file larger than 256 MiB");
    const Verdict crowd = explained(Outcome::crash, 0, "started more than 64 processes");
    EXPECT_EQ(crowd.status, Status::crash);
    EXPECT_EQ(crowd.message, "turn started more than 64 processes");
}

TEST(Explain, TamperingSaysWhat) {
    const Verdict verdict = explained(Outcome::tampered, 0, "an answer that nobody asked for");
    EXPECT_EQ(verdict.status, Status::tampered);
    EXPECT_EQ(verdict.message, "turn: an answer that nobody asked for");
}

TEST(Explain, TheGradersOwnFaultsAreNoStudents) {
    for (const Outcome outcome : {Outcome::unknown, Outcome::faulty}) {
        EXPECT_EQ(explained(outcome, 0, "no GL library").status, Status::graderError);
        EXPECT_EQ(explained(outcome, 0, "no GL library").message, "no GL library");
    }
    EXPECT_EQ(explained(Outcome::ok).status, Status::graderError);
}

}  // namespace
