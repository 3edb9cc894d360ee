#include "watch/Signals.h"

#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "Error.h"

namespace grader {

Signals::Signals() {
    sigset_t mine;
    sigemptyset(&mine);
    for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGCONT})
        sigaddset(&mine, each);
    sigprocmask(SIG_BLOCK, &mine, &before_);
    descriptor_ = signalfd(-1, &mine, SFD_NONBLOCK | SFD_CLOEXEC);
    if (descriptor_ < 0) {
        sigprocmask(SIG_SETMASK, &before_, nullptr);
        throw Error("signals cannot be waited for: {}", std::strerror(errno));
    }
}

Signals::~Signals() {
    close(descriptor_);
    sigprocmask(SIG_SETMASK, &before_, nullptr);
}

void Signals::stop() const {
    sigset_t stops;
    sigemptyset(&stops);
    sigaddset(&stops, SIGTSTP);
    raise(SIGTSTP);
    sigprocmask(SIG_UNBLOCK, &stops, nullptr);  // here it stops
    sigprocmask(SIG_BLOCK, &stops, nullptr);
}

int Signals::take() const {
    signalfd_siginfo info{};
    return read(descriptor_, &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo)
                                                                : 0;
}

}  // namespace grader
