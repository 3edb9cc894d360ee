#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "Fields.h"
#include "Files.h"

namespace grader {

/// One piece of work in a process of its own, a copy of this one as it is now: so whatever this
/// process holds ready needs no loading, the work can be abandoned at any moment, and the memory
/// that it took is given back.
///
/// To be used by a process with a single thread.
class GradingProcess {
public:
    /// Sends a message to the process that started the work.
    using Tell = std::function<void(const Json& message)>;

    /// Starts `work`. What it throws becomes `failure()`.
    explicit GradingProcess(const std::function<void(const Tell&)>& work);

    /// Abandons what has not ended: nothing that was started for it stays alive, and no file of
    /// its work is left.
    ~GradingProcess();
    GradingProcess(const GradingProcess&) = delete;
    GradingProcess& operator=(const GradingProcess&) = delete;

    /// Can be read from when there is a message, or when the work has ended.
    int descriptor() const { return channel_; }

    /// The messages that have arrived whole since the last call; never waits.
    std::vector<Json> take();

    /// Whether the last take() found the end of the work.
    bool ended() const { return ended_; }

    /// Once it has ended: what went wrong, empty when nothing did.
    const std::string& failure() const { return failure_; }

private:
    void end();

    WorkFolder work_;  ///< its temporary folder
    pid_t pid_ = -1;
    int channel_ = -1;
    std::string unread_;  ///< the beginning of a message
    bool ended_ = false;
    std::string failure_;
};

}  // namespace grader
