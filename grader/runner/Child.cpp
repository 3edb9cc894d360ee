#include "runner/Child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

#include "runner/CrashReport.h"
#include "runner/Usage.h"

namespace runner {

namespace {

using protocol::Answer;
using protocol::Bytes;
using protocol::Outcome;
using protocol::Request;
using protocol::RequestKind;

constexpr const char* kNoAnswer = "bytes that are no answer came out of the submission's process";
constexpr std::size_t kKeptOutput = 16384;
constexpr int kLoaderFailed = 127;  // what ld.so exits with
constexpr int kWatchMs = 20;        // how often what the child uses is looked at

struct Pipes {
    int channel[2], output[2], crash[2];
};

Pipes openPipes() {
    Pipes pipes{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pipes.channel) != 0 ||
        pipe2(pipes.output, O_CLOEXEC) != 0 || pipe2(pipes.crash, O_CLOEXEC) != 0)
        throw std::system_error(errno, std::generic_category(), "cannot open a pipe");
    fcntl(pipes.output[0], F_SETFL, O_NONBLOCK);
    fcntl(pipes.crash[0], F_SETFL, O_NONBLOCK);
    return pipes;
}

/// In the child: three standard descriptors, the channel and the crash pipe; nothing else.
[[noreturn]] void runChild(const SubjectFiles& files, const Pipes& pipes) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_DUMPABLE, 1);  // the parent looks at what this one uses
    const int nothing = open("/dev/null", O_RDONLY);
    const int channel = fcntl(pipes.channel[1], F_DUPFD, 10);
    const int crash = fcntl(pipes.crash[1], F_DUPFD, 10);
    const int output = fcntl(pipes.output[1], F_DUPFD, 10);
    dup2(nothing, 0);
    dup2(output, 1);
    dup2(output, 2);
    dup2(channel, 3);
    dup2(crash, 4);
    close_range(5, ~0U, 0);
    installCrashHandlers(4);
    Host(files).serve(3);
}

std::string trimmed(const std::string& text) {
    const auto end = text.find_last_not_of(" \n\t");
    return end == std::string::npos ? "" : text.substr(0, end + 1);
}

/// Children that are meant to live.
std::set<pid_t> living;

double secondsOf(const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}

std::string inMib(std::size_t bytes) {
    return std::to_string(bytes / (1024 * 1024)) + " MiB";
}

/// "the 64 MiB of /tmp", where that is full to the last page. Only the first process of a sandbox
/// has such folders to itself; elsewhere they are the machine's.
std::string filledFolder() {
    if (getpid() != 1)
        return {};
    for (const char* folder : {"/tmp", "/dev/shm"}) {
        struct statvfs size {};
        if (statvfs(folder, &size) == 0 && size.f_blocks > 0 && size.f_bavail == 0)
            return "the " + inMib(size.f_blocks * size.f_frsize) + " of " + folder;
    }
    return {};
}

/// Kills what `group` left behind: its process group, then all that was orphaned, until nothing but
/// the living is left.
void killStrays(pid_t group) {
    constexpr int kMostRounds = 200;
    kill(-group, SIGKILL);
    if (getpid() == 1 && living.empty())
        kill(-1, SIGKILL);  // a pid namespace of our own: all at once
    for (int round = 0; round < kMostRounds; ++round) {
        bool any = false;
        for (const pid_t pid : childrenOfThisProcess()) {
            if (living.contains(pid))
                continue;
            any = true;
            kill(pid, SIGKILL);
            waitpid(pid, nullptr, 0);
        }
        if (!any)
            return;
    }
}

}  // namespace

Child::Child(const SubjectFiles& files) : files_(files) {
    const Pipes pipes = openPipes();
    pid_ = fork();
    if (pid_ == 0)
        runChild(files, pipes);
    const int failure = errno;
    close(pipes.channel[1]);
    close(pipes.output[1]);
    close(pipes.crash[1]);
    channel_ = pipes.channel[0];
    output_ = pipes.output[0];
    crash_ = pipes.crash[0];
    if (pid_ < 0) {
        close(channel_);
        close(output_);
        close(crash_);
        throw std::system_error(failure, std::generic_category(), "cannot fork");
    }
    setpgid(pid_, pid_);
    living.insert(pid_);
}

Child::~Child() {
    stop(false);
    close(channel_);
    close(output_);
    close(crash_);
}

Answer Child::ask(const Request& request) {
    Answer answer;
    if (request.kind != RequestKind::call && !std::exchange(draws_, true))
        answer = startOpenGl();
    if (answer.outcome == Outcome::ok)
        answer = exchange(request);
    answer.nonce = request.nonce;
    return answer;
}

Answer Child::startOpenGl() {
    Request start;
    start.kind = RequestKind::graphics;
    start.timeoutMs = protocol::kStartMs;
    Answer answer = exchange(start);
    if (answer.outcome != Outcome::ok && answer.outcome != Outcome::faulty) {
        answer = {};
        answer.outcome = Outcome::faulty;
        answer.detail = "OpenGL did not start";
    }
    return answer;
}

Answer Child::exchange(Request request) {
    printed_.clear();
    printedBytes_ = 0;
    if (hasUnreadBytes())
        return endedFor(Outcome::tampered, kNoAnswer);
    request.nonce = protocol::freshNonce();
    protocol::writeAll(channel_,
                       protocol::framed(protocol::kRequestMagic, protocol::encodeRequest(request)));
    Answer answer = await(request);
    if (answer.outcome == Outcome::memory)
        answer.detail = inMib(allowance().memoryBytes);
    return answer;
}

Answer Child::await(const Request& request) {
    using namespace std::chrono;
    const milliseconds allowed(request.timeoutMs);
    const auto start = steady_clock::now();
    const auto waitedBefore = waitedForProcessor(pid_);
    nanoseconds waitedForDisk{0};
    auto end = start + allowed;
    auto lastLook = start;
    protocol::MessageReader answer(protocol::kAnswerMagic, protocol::kLargestAnswer);
    pollfd waiting[2] = {{channel_, POLLIN, 0}, {output_, POLLIN, 0}};
    for (;;) {
        auto left = ceil<milliseconds>(end - steady_clock::now()).count();
        if (left <= 0) {
            const nanoseconds owed = waitedForProcessor(pid_) - waitedBefore + waitedForDisk;
            end = start + std::min<nanoseconds>(allowed + owed, allowed * protocol::kMostStretch);
            left = ceil<milliseconds>(end - steady_clock::now()).count();
        }
        if (left <= 0)
            return endedFor(Outcome::timeout);
        if (poll(waiting, 2, static_cast<int>(std::min<long>(left, kWatchMs))) < 0)
            continue;
        if (const auto now = steady_clock::now(); now - lastLook >= milliseconds(kWatchMs)) {
            if (const auto excess = excessOfUse())
                return *excess;
            if (waitsForDisk(pid_))
                waitedForDisk += now - lastLook;
            lastLook = now;
        }
        if (waiting[1].revents & (POLLIN | POLLHUP))
            drainOutput();
        if (waiting[1].revents & POLLHUP)
            waiting[1].fd = -1;  // closed by the child itself: nothing more to watch
        if (printedBytes_ > request.outputBytes)
            return endedFor(Outcome::output);
        if (!waiting[0].revents)
            continue;
        const auto status = answer.step(channel_);
        if (!status)
            continue;
        drainOutput();
        if (const auto excess = excessOfFiles())
            return *excess;
        if (*status == protocol::ReadStatus::closed)
            return explainEnd(stop(true));
        if (printedBytes_ > request.outputBytes)
            return endedFor(Outcome::output);
        return explainAnswer(answer.body(), request.nonce);
    }
}

Answer Child::endedFor(Outcome outcome, const std::string& detail) {
    stop(false);
    Answer answer;
    answer.outcome = outcome;
    answer.detail = detail;
    return answer;
}

std::optional<Answer> Child::excessOfUse() {
    std::vector<pid_t> others;
    std::copy_if(living.begin(), living.end(), std::back_inserter(others),
                 [this](pid_t pid) { return pid != pid_; });
    const Usage used = usageWithout(others);
    const Allowance allowed = allowance();
    if (used.memoryBytes > allowed.memoryBytes)
        return endedFor(Outcome::memory);
    constexpr std::size_t kOwnThreads = 2;  // this process, and bubblewrap's where it waits
    if (used.threads + kOwnThreads >= allowed.threads)
        return endedFor(Outcome::crash,
                        "started more than " + std::to_string(allowed.threads) + " processes");
    return excessOfFiles();
}

std::optional<Answer> Child::excessOfFiles() {
    const std::size_t most = allowance().openFiles;
    if (openFilesOf(pid_) >= most)
        return endedFor(Outcome::crash,
                        "opened all the " + std::to_string(most) + " files that it may have open");
    if (const std::string folder = filledFolder(); !folder.empty())
        return endedFor(Outcome::output, "filled " + folder);
    return std::nullopt;
}

bool Child::hasUnreadBytes() const {
    char byte;
    return recv(channel_, &byte, 1, MSG_DONTWAIT | MSG_PEEK) > 0;
}

void Child::drainOutput() {
    char buffer[8192];
    // Bounded, so that a flood cannot hold the parent here.
    for (int round = 0; round < 64; ++round) {
        const ssize_t got = read(output_, buffer, sizeof buffer);
        if (got <= 0)
            return;
        printedBytes_ += static_cast<std::size_t>(got);
        if (printed_.size() < kKeptOutput)
            printed_.append(buffer, static_cast<std::size_t>(got));
    }
}

int Child::stop(bool letItEnd) {
    if (pid_ <= 0)
        return 0;
    const pid_t pid = std::exchange(pid_, -1);
    int status = 0;
    rusage used{};
    bool ended = false;
    // A child that closed its channel is ending, or plays dead: it gets a moment, not more.
    for (int waited = 0; letItEnd && !ended && waited < 200; ++waited) {
        ended = wait4(pid, &status, WNOHANG, &used) == pid;
        if (!ended)
            usleep(1000);
    }
    if (!ended) {
        kill(pid, SIGKILL);
        wait4(pid, &status, 0, &used);
    }
    cpuSeconds_ = secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
    living.erase(pid);
    killStrays(pid);
    return status;
}

Answer Child::explainAnswer(const Bytes& body, const protocol::Nonce& nonce) {
    Answer answer;
    try {
        answer = protocol::decodeAnswer(body);
        if (answer.nonce != nonce || hasUnreadBytes())
            throw protocol::ProtocolError("not the answer, or more than that");
    } catch (const protocol::ProtocolError&) {
        return endedFor(Outcome::tampered, kNoAnswer);
    }
    if (answer.outcome == Outcome::missing && answer.detail.starts_with("_Z"))
        answer.detail = describeMissingSymbol(files_.object, answer.detail);
    return answer;
}

Answer Child::explainEnd(int waitStatus) {
    Answer answer;
    if (WIFSIGNALED(waitStatus)) {
        answer.outcome = Outcome::crash;
        answer.code = WTERMSIG(waitStatus);
        if (answer.code == SIGXFSZ) {
            answer.outcome = Outcome::output;
            answer.detail = "wrote a file larger than " + inMib(allowance().fileBytes);
            return answer;
        }
        // The kernel's limit counts whole ticks, of which a crowded machine gives a process a part.
        const bool spent = cpuSeconds_ >= 0.5 * static_cast<double>(allowance().cpuSeconds);
        if ((answer.code == SIGKILL || answer.code == SIGXCPU) && spent) {
            answer.outcome = Outcome::timeout;
            answer.detail = "used up the " + std::to_string(allowance().cpuSeconds) +
                            " s of processor time that it may have";
            return answer;
        }
        std::vector<std::uint64_t> report(kLongestReport);
        const ssize_t got = read(crash_, report.data(), report.size() * sizeof report[0]);
        report.resize(got > 0 ? static_cast<std::size_t>(got) / sizeof report[0] : 0);
        answer.detail = describeCrash(files_.object, report);
        return answer;
    }
    answer.outcome = Outcome::exited;
    answer.code = WEXITSTATUS(waitStatus);
    const std::string marker = "undefined symbol: ";
    if (const auto at = printed_.find(marker);
        answer.code == kLoaderFailed && at != std::string::npos) {
        answer.outcome = Outcome::missing;
        answer.detail =
            describeMissingSymbol(files_.object, trimmed(printed_.substr(at + marker.size())));
    }
    return answer;
}

}  // namespace runner
