#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace testing_help {

/// A program in a terminal of its own, as in a window in which somebody types.
class PseudoTerminal {
public:
    /// Starts it, 80 columns wide. Throws std::runtime_error when there is no terminal to be had.
    explicit PseudoTerminal(const std::vector<std::string>& command);
    /// Kills what has not ended.
    ~PseudoTerminal();
    PseudoTerminal(const PseudoTerminal&) = delete;
    PseudoTerminal& operator=(const PseudoTerminal&) = delete;

    void type(const std::string& keys) const;

    /// Waits until this has been written since the last text that was waited for, and returns what
    /// came before it. Throws std::runtime_error, with what came, when it does not come in time.
    std::string waitFor(const std::string& text, double seconds = 60);

    /// Waits until nothing has been written for so long; returns what was, since the last wait.
    std::string untilSilent(double seconds);

    /// Waits for the end. The exit code; minus the signal that ended it.
    int waitForEnd(double seconds = 60);

    /// Whether the terminal puts lines together and echoes, as a shell's does.
    bool isAsBefore() const;

    pid_t pid() const { return pid_; }

private:
    bool readSome(int timeoutMs);

    pid_t pid_ = -1;
    int terminal_ = -1;
    std::string unread_;
};

}  // namespace testing_help
