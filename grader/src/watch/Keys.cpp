#include "watch/Keys.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <utility>

namespace grader {

namespace {

/// A program in the background that changes its terminal is stopped for it, unless it blocks the
/// signal: what must be put right at the end is put right even then.
void setTerminal(const termios& state) {
    sigset_t stops, before;
    sigemptyset(&stops);
    sigaddset(&stops, SIGTTOU);
    sigprocmask(SIG_BLOCK, &stops, &before);
    tcsetattr(STDIN_FILENO, TCSADRAIN, &state);
    sigprocmask(SIG_SETMASK, &before, nullptr);
}

bool isInForeground() {
    return tcgetpgrp(STDIN_FILENO) == getpgrp();
}

}  // namespace

Keys::Keys() {
    termios state{};
    if (!isatty(STDIN_FILENO) || !isatty(STDOUT_FILENO) || !isInForeground() ||
        tcgetattr(STDIN_FILENO, &state) != 0)
        return;
    before_ = state;
    resume();
}

Keys::~Keys() {
    suspend();
}

int Keys::descriptor() const {
    return listening_ ? STDIN_FILENO : -1;
}

std::string Keys::pressed() {
    char keys[64];
    const ssize_t got = read(STDIN_FILENO, keys, sizeof keys);
    if (got > 0)
        return {keys, static_cast<std::size_t>(got)};
    if (got == 0 || errno != EINTR) {
        before_.reset();
        listening_ = false;
    }
    return "";
}

void Keys::suspend() {
    if (std::exchange(listening_, false))
        setTerminal(*before_);
}

void Keys::resume() {
    if (!before_ || !isInForeground())
        return;
    termios single = *before_;
    single.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    single.c_cc[VMIN] = 1;
    single.c_cc[VTIME] = 0;
    setTerminal(single);
    listening_ = true;
}

}  // namespace grader
