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

/// In the child, where nothing may be allocated: a thread that is gone may have held that lock.
[[noreturn]] void become(char* const* arguments, int output) {
    setsid();  // a group of its own, and no terminal
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, 0);
    dup2(output, 1);
    dup2(output, 2);
    close_range(3, ~0U, 0);
    execvp(arguments[0], arguments);
    dprintf(2, "cannot start %s: %s\n", arguments[0], std::strerror(errno));
    _exit(127);
}

}  // namespace

ProcessResult run(const std::vector<std::string>& command, double timeoutSeconds,
                  std::size_t outputLimit) {
    using namespace std::chrono;
    TimeBox::check();
    int pipes[2];
    if (pipe2(pipes, O_CLOEXEC) != 0)
        throw Error("no pipe can be opened: {}", std::strerror(errno));
    std::vector<char*> arguments;
    for (const std::string& each : command)
        arguments.push_back(const_cast<char*>(each.c_str()));
    arguments.push_back(nullptr);
    const pid_t pid = fork();
    if (pid == 0)
        become(arguments.data(), pipes[1]);
    const int reason = errno;
    close(pipes[1]);
    if (pid < 0) {
        close(pipes[0]);
        throw Error("{} cannot be started: {}", command.front(), std::strerror(reason));
    }

    ProcessResult result;
    const auto begun = steady_clock::now();
    const time_point<steady_clock, duration<double>> own = begun + duration<double>(timeoutSeconds);
    const bool boxed = TimeBox::end() < own;
    const auto end = boxed ? TimeBox::end() : own;
    for (char buffer[16384];;) {
        const auto left = ceil<milliseconds>(end - steady_clock::now()).count();
        pollfd waiting{pipes[0], POLLIN, 0};
        const int ready = left <= 0 ? 0 : poll(&waiting, 1, static_cast<int>(left));
        if (ready == 0) {
            result.timedOut = true;
            break;
        }
        if (ready < 0 && errno == EINTR)
            continue;
        const ssize_t got = read(pipes[0], buffer, sizeof buffer);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            break;
        result.output.append(buffer, static_cast<std::size_t>(got));
        if (result.output.size() > outputLimit)
            break;
    }
    if (result.timedOut || result.output.size() > outputLimit) {
        kill(pid, SIGKILL);  // it may not lead its group yet
        kill(-pid, SIGKILL);
    }
    result.output.resize(std::min(result.output.size(), outputLimit));
    close(pipes[0]);
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    kill(-pid, SIGKILL);  // whatever it left behind
    result.seconds = duration<double>(steady_clock::now() - begun).count();
    if (WIFSIGNALED(status))
        result.signal = WTERMSIG(status);
    else
        result.exitCode = WEXITSTATUS(status);
    if (result.timedOut && boxed)
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
