#include "runner/Child.h"

#include <cg/gl.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <optional>
#include <string_view>
#include <thread>

#include "runner/Census.h"
#include "runner/CrashReport.h"
#include "runner/Usage.h"

namespace {

using namespace protocol;
using testing::HasSubstr;

const runner::SubjectFiles kFiles{GREEDY_SUBJECT, "/nowhere", "auto"};

Request requestFor(const std::string& function, std::uint32_t ms = 20000) {
    Request request;
    request.name = function;
    request.arguments = encode(1);
    request.timeoutMs = ms;
    return request;
}

/// Asks a fresh child.
Answer answerWithin(std::uint32_t ms, const std::string& function) {
    return runner::Child(kFiles).ask(requestFor(function, ms));
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

/// A child that writes to its channel at a signal, as a thread that an earlier request left behind
/// may do at any time.
class LateBytes : public testing::Test {
protected:
    /// It has answered once, so its channel is open.
    runner::Child& childThatWrites(const Bytes& bytes) {
        late = bytes;
        written = false;
        const auto before =
            std::signal(SIGUSR1, [](int) { written = ::write(3, late.data(), late.size()) > 0; });
        child_.emplace(kFiles);
        std::signal(SIGUSR1, before);
        pid_ = runner::childrenOfThisProcess().at(0);
        EXPECT_EQ(child_->ask(requestFor("modest")).outcome, Outcome::ok);
        return *child_;
    }
    void write() { kill(pid_, SIGUSR1); }

    static inline std::atomic<bool>& written = *static_cast<std::atomic<bool>*>(
        mmap(nullptr, 1, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));

private:
    static inline Bytes late;
    std::optional<runner::Child> child_;
    pid_t pid_ = 0;
};

TEST_F(LateBytes, AnAnswerIsNotTakenForThatToTheNextRequest) {
    Answer forged;
    forged.payload = encode(666);
    runner::Child& child = childThatWrites(framed(kAnswerMagic, encodeAnswer(forged)));
    std::thread later([&] {
        usleep(100'000);
        write();
    });
    const Answer answer = child.ask(requestFor("spin"));
    later.join();
    EXPECT_EQ(answer.outcome, Outcome::tampered);
    EXPECT_TRUE(answer.payload.empty()) << "nothing of a forged answer is used";
    EXPECT_FALSE(child.alive());
}

TEST_F(LateBytes, NoRequestIsSentAfterBytesThatNobodyAskedFor) {
    // The next answer would be taken for the rest of this one.
    runner::Child& child = childThatWrites({'C', 'G', 'A', 'N', 0xff, 0, 0, 0});
    write();
    while (!written)
        usleep(1000);
    EXPECT_EQ(child.ask(requestFor("modest", 500)).outcome, Outcome::tampered);
    EXPECT_FALSE(child.alive());
}

TEST(Child, AnAnswerHasTheNonceOfItsRequest) {
    Request request = requestFor("modest");
    request.nonce = {3, 4};
    EXPECT_EQ(runner::Child(kFiles).ask(request).nonce, request.nonce);
}

TEST(Child, TheStartOfOpenGlIsNotCharged) {
    runner::Child child(kFiles);
    const pid_t pid = runner::childrenOfThisProcess().at(0);
    kill(pid, SIGSTOP);  // a start that takes its time
    std::thread later([&] {
        usleep(1'500'000);
        kill(pid, SIGCONT);
    });
    Request request = requestFor("modest", 1000);
    request.kind = RequestKind::draw;
    const Answer answer = child.ask(request);
    later.join();
    if (answer.outcome == Outcome::faulty)
        GTEST_SKIP() << answer.detail;
    EXPECT_EQ(answer.outcome, Outcome::ok);
}

/// A driver that dies as soon as it has work to do.
class DyingDriver : public cg::Context {
public:
    DyingDriver() : Context(1, 1) {}
    const char* provider() const override { return "none"; }
    void makeCurrent() override {}
    void* function(const char* name) const override {
        const bool asksOnly = std::string_view(name).starts_with("glGet");
        return reinterpret_cast<void*>(asksOnly ? +[] {} : +[] { std::raise(SIGSEGV); });
    }
};

std::string crashOf(void (*work)()) {
    int ends[2];
    EXPECT_EQ(pipe2(ends, O_CLOEXEC), 0);
    const pid_t pid = fork();
    if (pid == 0) {
        const DyingDriver driver;
        runner::setCensusContext(&driver);
        runner::installCrashHandlers(ends[1]);
        work();
        _exit(0);
    }
    close(ends[1]);
    std::vector<std::uint64_t> report(runner::kLongestReport);
    const ssize_t got = read(ends[0], report.data(), report.size() * sizeof report[0]);
    report.resize(got > 0 ? static_cast<std::size_t>(got) / sizeof report[0] : 0);
    close(ends[0]);
    waitpid(pid, nullptr, 0);
    return runner::describeCrash("/nowhere", report);
}

TEST(CrashReport, SaysWhetherTheDriverWasAtWork) {
    EXPECT_EQ(crashOf([] { glCompileShader(1); }),
              "the driver's shader compiler, called by your code");
    EXPECT_EQ(crashOf([] { glLinkProgram(1); }),
              "the driver's shader compiler, called by your code");
    EXPECT_EQ(crashOf([] { glDrawArrays(GL_POINTS, 0, 1); }),
              "the driver (OpenGL), called by your code");
    EXPECT_EQ(crashOf([] { std::raise(SIGSEGV); }), "");
}

}  // namespace
