#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "protocol/Message.h"
#include "protocol/Value.h"
#include "subject/Status.h"

namespace judge {

/// A request did not bring a value. Leaves the test that made it.
struct SubjectFailure : std::runtime_error {
    explicit SubjectFailure(Verdict why) : std::runtime_error(why.message), verdict(std::move(why)) {}
    Verdict verdict;
};

/// The judge's side of a student's code. A test reads as if the functions were local.
class Subject {
public:
    virtual ~Subject() = default;

    /// Sends one request and returns what became of it; never throws for the student's faults.
    virtual protocol::Answer ask(protocol::Request request) = 0;

    /// Calls a function of the harness. Throws SubjectFailure when no value of type R comes back.
    template <class R, class... A>
    R call(const std::string& function, const A&... arguments) {
        const protocol::Answer answer = askForCall(function, protocol::encode(arguments...));
        try {
            return protocol::decode<R>(answer.payload);
        } catch (const protocol::ProtocolError& error) {
            giveUp({Status::graderError, function + ": " + error.what()});
        }
    }

    /// Told the ids of unfilled regions that a request reached.
    std::function<void(const std::vector<std::string>&)> onTodos = [](const auto&) {};
    /// Told why a call brings no value, before SubjectFailure is thrown.
    std::function<void(const Verdict&)> onFailure = [](const auto&) {};

    std::uint32_t callTimeoutMs = 2000;
    std::uint32_t outputBytes = 65536;

private:
    [[noreturn]] void giveUp(const Verdict& why);
    protocol::Answer askForCall(const std::string& function, protocol::Bytes arguments);

    std::vector<std::string> timedOut_;  ///< not called again: one endless loop costs one time-out
};

/// A subject in a process of its own.
///
/// `command` starts the runner (with its sandbox); the number of the descriptor for the judge is
/// appended to it. The runner is started at the first request, and again when it ends.
std::unique_ptr<Subject> startSubject(std::vector<std::string> command);

}  // namespace judge
