#pragma once

#include <csignal>

namespace grader {

/// Signals from the terminal or from another program, as a descriptor to wait for, as long as it
/// lives: the end (SIGINT, SIGTERM, SIGHUP, SIGQUIT), Ctrl-Z (SIGTSTP) and going on (SIGCONT).
/// They are blocked meanwhile, in programs that are started, too, unless those unblock them.
class Signals {
public:
    Signals();
    ~Signals();
    Signals(const Signals&) = delete;
    Signals& operator=(const Signals&) = delete;

    int descriptor() const { return descriptor_; }

    /// The next one; 0 when there is none.
    int take() const;

    /// Stops this program as Ctrl-Z does: not where nobody above it could let it go on.
    void stop() const;

private:
    sigset_t before_{};
    int descriptor_ = -1;
};

}  // namespace grader
