#include "Process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "Error.h"
#include "TimeBox.h"

namespace grader {

namespace {

using Clock = std::chrono::steady_clock;

/// One that the child writes to and we read from.
class Pipe {
public:
    Pipe() {
        if (pipe2(ends_, O_CLOEXEC) != 0)
            throw Error("no pipe can be opened: {}", std::strerror(errno));
    }
    ~Pipe() {
        closeWriting();
        close(ends_[0]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    int reading() const { return ends_[0]; }
    int writing() const { return ends_[1]; }
    void closeWriting() {
        if (ends_[1] >= 0)
            close(ends_[1]);
        ends_[1] = -1;
    }

private:
    int ends_[2];
};

/// In the child, where nothing may be allocated: a thread that is gone may have held that lock.
[[noreturn]] void become(char* const* arguments, int output, int errors, pid_t parent) {
    setsid();  // a group of its own, and no terminal
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(1);  // it ended before it could take us along
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, 0);
    dup2(output, 1);
    dup2(errors, 2);
    close_range(3, ~0U, 0);
    execvp(arguments[0], arguments);
    dprintf(2, "cannot start %s: %s\n", arguments[0], std::strerror(errno));
    _exit(127);
}

struct Stream {
    int descriptor;
    std::string& text;
};

enum class Reading { ended, outOfTime, full };

/// Reads from streams until each has ended, and keeps of each what the options say.
Reading readAll(const std::vector<Stream>& streams, const RunOptions& options,
                Clock::time_point end, bool& cut) {
    std::vector<pollfd> open;
    for (const Stream& each : streams)
        open.push_back({each.descriptor, POLLIN, 0});
    for (char buffer[16384];
         std::any_of(open.begin(), open.end(), [](const pollfd& each) { return each.fd >= 0; });) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0)
            return Reading::outOfTime;
        constexpr std::int64_t kLookAgain = 60'000;
        if (poll(open.data(), open.size(), int(std::min<std::int64_t>(left, kLookAgain))) <= 0)
            continue;
        for (std::size_t i = 0; i < open.size(); ++i) {
            if (open[i].revents == 0)
                continue;
            const ssize_t got = read(open[i].fd, buffer, sizeof buffer);
            if (got == 0 || (got < 0 && errno != EINTR))
                open[i].fd = -1;  // which poll() passes over
            const auto bytes = static_cast<std::size_t>(std::max<ssize_t>(got, 0));
            const auto kept = std::min(bytes, options.outputLimit - streams[i].text.size());
            streams[i].text.append(buffer, kept);
            cut = cut || kept < bytes;
        }
        if (cut && options.endAtLimit)
            return Reading::full;
    }
    return Reading::ended;
}

/// Waits for the end of a child that has no more to say, which is not reaped: its number, and that
/// of its group, are still its own. False when the time is up before.
bool endsBefore(pid_t pid, Clock::time_point end) {
    for (siginfo_t info{};
         waitid(P_PID, id_t(pid), &info, WEXITED | WNOWAIT | WNOHANG) == 0 || errno == EINTR;
         usleep(200)) {
        if (info.si_pid == pid)
            break;
        if (Clock::now() >= end)
            return false;
    }
    return true;
}

}  // namespace

ProcessResult run(const std::vector<std::string>& command, double timeoutSeconds,
                  const RunOptions& options) {
    TimeBox::check();
    Pipe output, errors;
    std::vector<char*> arguments;
    for (const std::string& each : command)
        arguments.push_back(const_cast<char*>(each.c_str()));
    arguments.push_back(nullptr);
    const pid_t parent = getpid();
    const pid_t pid = fork();
    if (pid == 0)
        become(arguments.data(), output.writing(),
               options.errorsApart ? errors.writing() : output.writing(), parent);
    if (pid < 0)
        throw Error("{} cannot be started: {}", command.front(), std::strerror(errno));
    output.closeWriting();
    errors.closeWriting();

    ProcessResult result;
    const auto begun = Clock::now();
    constexpr double kForever = 1e7;
    const auto own = begun + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(std::min(timeoutSeconds, kForever)));
    const auto end = std::min(own, TimeBox::end());
    const Reading reading =
        readAll({{output.reading(), result.output}, {errors.reading(), result.errors}}, options,
                end, result.cut);
    result.timedOut =
        reading == Reading::outOfTime || (reading == Reading::ended && !endsBefore(pid, end));
    if (result.timedOut || reading == Reading::full)
        kill(pid, SIGKILL);  // it may not lead its group yet
    kill(-pid, SIGKILL);     // and whatever it left behind
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    result.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    if (WIFSIGNALED(status))
        result.signal = WTERMSIG(status);
    else
        result.exitCode = WEXITSTATUS(status);
    if (result.timedOut && end < own)
        TimeBox::giveUp();
    return result;
}

double cpuSeconds() {
    double sum = 0.0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(who, &usage);
        for (const timeval& time : {usage.ru_utime, usage.ru_stime})
            sum += static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
    }
    return sum;
}

}  // namespace grader
