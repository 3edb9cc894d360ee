#include "runner/Child.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace {

using namespace protocol;
using testing::HasSubstr;

const runner::SubjectFiles kFiles{GREEDY_SUBJECT, "/nowhere", "auto"};

/// Asks a fresh child.
Answer answerWithin(std::uint32_t ms, const std::string& function) {
    Request request;
    request.name = function;
    request.arguments = encode(1);
    request.timeoutMs = ms;
    return runner::Child(kFiles).ask(request);
}

/// Asks a fresh child under a limit of this process, which is set back afterwards.
Answer answerUnder(const std::string& function, __rlimit_resource_t resource, rlim_t most) {
    rlimit before{};
    getrlimit(resource, &before);
    const rlimit lower{most, before.rlim_max};
    setrlimit(resource, &lower);
    Answer answer = answerWithin(20000, function);
    setrlimit(resource, &before);
    return answer;
}

TEST(Child, AnswersWithWhatTheFunctionReturns) {
    const Answer answer = answerUnder("modest", RLIMIT_NOFILE, 100);
    ASSERT_EQ(answer.outcome, Outcome::ok) << answer.detail;
    EXPECT_EQ(decode<int>(answer.payload), 2);
}

TEST(Child, ProcessorTimeThatIsUsedUpIsCalledSo) {
    const Answer answer = answerUnder("spin", RLIMIT_CPU, 1);
    EXPECT_EQ(answer.outcome, Outcome::timeout);
    EXPECT_THAT(answer.detail, HasSubstr("used up the 1 s of processor time"));
}

TEST(Child, WaitingForADiskCostsNoTimeSleepingDoes) {
    EXPECT_EQ(answerWithin(500, "wait").outcome, Outcome::ok) << "it took 1000 ms";
    EXPECT_EQ(answerWithin(500, "sleep").outcome, Outcome::timeout);
}

TEST(Child, OpeningAllFilesIsCalledSo) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer itself needs a descriptor where there is none left";
#endif
    const Answer answer = answerUnder("hoard", RLIMIT_NOFILE, 100);
    EXPECT_EQ(answer.outcome, Outcome::crash);
    EXPECT_THAT(answer.detail, HasSubstr("opened all the 100 files that it may have open"));
}

}  // namespace
