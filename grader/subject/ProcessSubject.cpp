#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "subject/EndAllIn.h"
#include "subject/Subject.h"

namespace judge {

namespace {

using protocol::Answer;
using protocol::Outcome;
using protocol::Request;

/// The runner keeps the time of a request itself; this much later the judge gives up on it.
constexpr int kGraceMs = 3000;
constexpr std::size_t kKeptErrors = 2000;
constexpr int kRunnerDescriptor = 3;

class ProcessSubject : public Subject {
public:
    ProcessSubject(std::vector<std::string> command, KernelLimits limits)
        : command_(std::move(command)), limits_(std::move(limits)) {
        command_.push_back(std::to_string(kRunnerDescriptor));
    }
    ~ProcessSubject() override { stop(); }

protected:
    Answer answerTo(Request request) override {
        // What an earlier request left running may have gone too far since: this one has no part in
        // it, and gets a new runner.
        if (kernelSteppedIn())
            startOver();
        if (pid_ < 0)
            start();
        request.nonce = protocol::freshNonce();
        protocol::writeAll(
            channel_, protocol::framed(protocol::kRequestMagic, protocol::encodeRequest(request)));
        protocol::Bytes body;
        const auto status = protocol::readMessage(
            channel_, protocol::kAnswerMagic, protocol::kLargestAnswer, patienceMs(request), body);
        const Answer answer = judged(request, status, body);
        const auto intervention = kernelSteppedIn();
        // What wrote too much may have filled a folder: the next one gets an empty one.
        if (intervention || answer.outcome == Outcome::output)
            startOver();
        return intervention.value_or(answer);
    }

private:
    static int patienceMs(const Request& request) {
        const bool draws = request.kind != protocol::RequestKind::call;
        const std::uint32_t allowed = request.timeoutMs + (draws ? protocol::kStartMs : 0);
        return static_cast<int>(allowed * protocol::kMostStretch) + kGraceMs;
    }

    /// What has happened in the cgroup since this was last asked, as an answer.
    std::optional<Answer> kernelSteppedIn() {
        const Interventions now = interventionsIn(limits_.cgroup);
        const Interventions before = std::exchange(seen_, now);
        Answer answer;
        if (now.memory > before.memory) {
            answer.outcome = Outcome::memory;
            answer.detail = std::to_string(limits_.memoryMib) + " MiB";
        } else if (now.processes > before.processes) {
            answer.outcome = Outcome::crash;
            answer.detail = "started more than " + std::to_string(limits_.processes) + " processes";
        } else {
            return std::nullopt;
        }
        return answer;
    }

    /// The next request gets a new runner, and no blame for what the kernel did to this one.
    void startOver() {
        stop();
        seen_ = interventionsIn(limits_.cgroup);
    }

    Answer judged(const Request& request, protocol::ReadStatus status,
                  const protocol::Bytes& body) {
        Answer answer;
        switch (status) {
            case protocol::ReadStatus::closed: {
                const std::string said = stop();
                return fault("the runner ended before it answered" +
                             (said.empty() ? std::string() : ": " + said));
            }
            case protocol::ReadStatus::late:
                stop();
                answer.outcome = Outcome::timeout;
                return answer;
            case protocol::ReadStatus::malformed:
                return tampered();
            case protocol::ReadStatus::ok:
                break;
        }
        try {
            answer = protocol::decodeAnswer(body);
        } catch (const protocol::ProtocolError&) {
            return tampered();
        }
        if (answer.nonce != request.nonce)
            return tampered();
        return answer;
    }

    Answer tampered() {
        stop();
        Answer answer;
        answer.outcome = Outcome::tampered;
        answer.detail = "an answer that nobody asked for";
        return answer;
    }

    static Answer fault(const std::string& why) {
        Answer answer;
        answer.outcome = Outcome::faulty;
        answer.detail = why;
        return answer;
    }

    /// What the last system call said, for a throw.
    static std::runtime_error cannot(const std::string& what) {
        return std::runtime_error("cannot " + what + ": " + std::strerror(errno));
    }

    void start() {
        int channel[2], errors[2];
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, channel) != 0)
            throw cannot("open a channel to the runner");
        if (pipe2(errors, O_CLOEXEC) != 0) {
            const auto why = cannot("open a pipe from the runner");
            close(channel[0]);
            close(channel[1]);
            throw why;
        }
        std::vector<char*> arguments;
        for (std::string& each : command_)
            arguments.push_back(each.data());
        arguments.push_back(nullptr);
        const pid_t parent = getpid();
        pid_ = fork();
        if (pid_ == 0) {
            setsid();  // a group of its own, and no terminal
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            if (getppid() != parent)
                _exit(1);
            const int inherited = fcntl(channel[1], F_DUPFD, 10);
            const int nothing = open("/dev/null", O_RDWR);
            dup2(nothing, 0);
            dup2(nothing, 1);
            dup2(errors[1], 2);
            dup2(inherited, kRunnerDescriptor);
            close_range(kRunnerDescriptor + 1, ~0U, 0);
            execvp(arguments[0], arguments.data());
            dprintf(2, "cannot start %s: %s\n", arguments[0], std::strerror(errno));
            _exit(127);
        }
        const auto why = cannot("fork");
        close(channel[1]);
        close(errors[1]);
        if (pid_ < 0) {
            close(channel[0]);
            close(errors[0]);
            throw why;
        }
        channel_ = channel[0];
        errors_ = errors[0];
        fcntl(errors_, F_SETFL, O_NONBLOCK);
    }

    /// Ends the runner; returns what it wrote to its standard error.
    std::string stop() {
        if (pid_ < 0)
            return {};
        close(channel_);    // a healthy runner ends by itself
        siginfo_t ended{};  // not reaped: its number is its own until the end
        for (int waited = 0; waited < 50 && ended.si_pid == 0; ++waited) {
            waitid(P_PID, id_t(pid_), &ended, WEXITED | WNOWAIT | WNOHANG);
            if (ended.si_pid == 0)
                usleep(1000);
        }
        kill(pid_, SIGKILL);  // it may not lead its group yet
        kill(-pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
        endAllIn(limits_.cgroup);
        std::string said(kKeptErrors, '\0');
        const ssize_t got = read(errors_, said.data(), said.size());
        said.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
        close(errors_);
        pid_ = -1;
        return said.substr(0, said.find_last_not_of('\n') + 1);
    }

    std::vector<std::string> command_;
    const KernelLimits limits_;
    Interventions seen_;
    pid_t pid_ = -1;
    int channel_ = -1;
    int errors_ = -1;
};

}  // namespace

std::unique_ptr<Subject> startSubject(std::vector<std::string> command, KernelLimits limits) {
    return std::make_unique<ProcessSubject>(std::move(command), std::move(limits));
}

}  // namespace judge
