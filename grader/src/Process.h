#pragma once

#include <string>
#include <vector>

namespace grader {

struct ProcessResult {
    int exitCode = -1;  ///< -1 when a signal ended it
    int signal = 0;
    bool timedOut = false;
    double seconds = 0.0;  ///< that it took, on the clock
    bool cut = false;      ///< it said more than was kept
    std::string output;    ///< its first bytes, with those of standard error unless that is apart
    std::string errors;    ///< of standard error, where it is apart
    bool succeeded() const { return exitCode == 0 && !timedOut; }
    /// By a signal of its own, or of what it ran, as bubblewrap and shells tell it: 128 + signal.
    bool endedBy(int number) const { return signal == number || exitCode == 128 + number; }
    /// Whether it can have used up so much processor time: nearly as much must have passed.
    bool canHaveUsed(double cpuSeconds) const { return seconds > 0.9 * cpuSeconds; }
};

struct RunOptions {
    std::size_t outputLimit = 1 << 20;  ///< bytes that are kept; what comes after them is dropped,
    bool endAtLimit = false;            ///< or the command ended
    bool errorsApart = false;           ///< standard error is no part of the output
};

/// Runs a command in a process group of its own and waits for it. After `timeoutSeconds` the whole
/// group is killed. Standard input is empty. A command that cannot be started ends with exit code
/// 127 and says why on standard error. Throws Error when the time of the thread's TimeBox is over;
/// then, too, the group is killed.
ProcessResult run(const std::vector<std::string>& command, double timeoutSeconds,
                  const RunOptions& options = {});

/// CPU seconds, user and system, of this process and of all children that have ended.
double cpuSeconds();

}  // namespace grader
