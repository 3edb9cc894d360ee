#include "testing/PseudoTerminal.h"

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <utility>

namespace testing_help {

namespace {

using Clock = std::chrono::steady_clock;

int msUntil(Clock::time_point end) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
    return left > 0 ? static_cast<int>(left) : 0;
}

Clock::time_point in(double seconds) {
    return Clock::now() +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

PseudoTerminal::PseudoTerminal(const std::vector<std::string>& command) {
    const winsize size{40, 80, 0, 0};
    pid_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (pid_ == 0) {
        setenv("TERM", "xterm", 1);
        setenv("NO_COLOR", "1", 1);
        std::vector<char*> arguments;
        for (const std::string& each : command)
            arguments.push_back(const_cast<char*>(each.c_str()));
        arguments.push_back(nullptr);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    if (pid_ < 0)
        throw std::runtime_error("no pseudo terminal can be opened");
}

PseudoTerminal::~PseudoTerminal() {
    if (pid_ > 0) {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    close(terminal_);
}

void PseudoTerminal::type(const std::string& keys) const {
    if (write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
        throw std::runtime_error("the terminal takes no keys");
}

bool PseudoTerminal::readSome(int timeoutMs) {
    pollfd waiting{terminal_, POLLIN, 0};
    if (poll(&waiting, 1, timeoutMs) <= 0)
        return false;
    char buffer[4096];
    const ssize_t got = read(terminal_, buffer, sizeof buffer);
    if (got <= 0)
        return false;
    unread_.append(buffer, static_cast<std::size_t>(got));
    return true;
}

std::string PseudoTerminal::waitFor(const std::string& text, double seconds) {
    const auto end = in(seconds);
    for (;;) {
        if (const auto at = unread_.find(text); at != std::string::npos) {
            const std::string before = unread_.substr(0, at);
            unread_.erase(0, at + text.size());
            return before;
        }
        if (!readSome(msUntil(end)))
            throw std::runtime_error("expected \"" + text + "\" on the terminal, found:\n" +
                                     unread_);
    }
}

std::string PseudoTerminal::untilSilent(double seconds) {
    while (readSome(static_cast<int>(seconds * 1000))) {
    }
    return std::exchange(unread_, "");
}

int PseudoTerminal::waitForEnd(double seconds) {
    const auto end = in(seconds);
    int status = 0;
    while (waitpid(pid_, &status, WNOHANG) == 0) {
        if (msUntil(end) == 0)
            throw std::runtime_error("the program did not end");
        readSome(10);
    }
    pid_ = -1;
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

bool PseudoTerminal::isAsBefore() const {
    termios state{};
    return tcgetattr(terminal_, &state) == 0 && (state.c_lflag & ICANON) != 0 &&
           (state.c_lflag & ECHO) != 0;
}

}  // namespace testing_help
