#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "protocol/Message.h"
#include "runner/Host.h"

namespace runner {

/// The parent's handle on one forked child that runs student code.
///
/// The parent itself never loads the subject: it passes requests down, watches time and output,
/// and says in plain data how the child ended.
class Child {
public:
    explicit Child(const SubjectFiles& files);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Serves one request. The nonce of the answer is the request's.
    protocol::Answer ask(const protocol::Request& request);

    /// False once the child has ended or was stopped; ask() then may not be called.
    bool alive() const { return pid_ > 0; }

private:
    enum class Event { answered, closed, late, flooded, greedy, crowded, hoarding };

    Event await(const protocol::Request& request, protocol::Bytes& body);
    /// Whether the child and all that it started use more together than one process may.
    std::optional<Event> excessOfUse() const;
    void drainOutput();
    bool holdsAllFiles() const;
    /// Kills the child with all it started, and reaps it. Returns the status of waitpid.
    int stop(bool letItEnd);
    protocol::Answer explainEnd(int waitStatus);
    protocol::Answer explainAnswer(const protocol::Bytes& body);

    const SubjectFiles& files_;
    pid_t pid_ = -1;
    int channel_ = -1;
    int output_ = -1;
    int crash_ = -1;
    double cpuSeconds_ = 0;         ///< of the child and what it waited for, once it has ended
    std::string printed_;           ///< the first part of what the child wrote
    std::size_t printedBytes_ = 0;  ///< all that it wrote in this request
};

}  // namespace runner
