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
    /// Makes the context, before anything of the subject is loaded: no request pays for it.
    protocol::Answer startOpenGl();
    /// Sends a request down, with a nonce of its own, and waits for what becomes of it.
    protocol::Answer exchange(protocol::Request request);
    protocol::Answer await(const protocol::Request& request);
    /// Ends the child when it and all that it started use more together than one process may.
    std::optional<protocol::Answer> excessOfUse();
    std::optional<protocol::Answer> excessOfFiles();
    /// Ends the child and says why.
    protocol::Answer endedFor(protocol::Outcome outcome, const std::string& detail = "");
    void drainOutput();
    bool hasUnreadBytes() const;
    /// Kills the child with all it started, and reaps it. Returns the status of waitpid.
    int stop(bool letItEnd);
    protocol::Answer explainEnd(int waitStatus);
    protocol::Answer explainAnswer(const protocol::Bytes& body, const protocol::Nonce& nonce);

    const SubjectFiles& files_;
    pid_t pid_ = -1;
    int channel_ = -1;
    int output_ = -1;
    int crash_ = -1;
    bool draws_ = false;            ///< OpenGL has been started
    double cpuSeconds_ = 0;         ///< of the child and what it waited for, once it has ended
    std::string printed_;           ///< the first part of what the child wrote
    std::size_t printedBytes_ = 0;  ///< all that it wrote in this request
};

}  // namespace runner
