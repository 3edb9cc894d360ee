#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "protocol/DrawCall.h"
#include "protocol/Message.h"
#include "protocol/Value.h"
#include "subject/KernelLimits.h"
#include "subject/Status.h"

namespace judge {

/// A request did not bring a value. Leaves the test that made it.
struct SubjectFailure : std::runtime_error {
    explicit SubjectFailure(Verdict why)
        : std::runtime_error(why.message), verdict(std::move(why)) {}
    Verdict verdict;
};

using Draw = protocol::DrawCall;

/// A value, and the draw calls that were made on the way to it, in their order.
template <class R>
struct Census {
    R result;
    std::vector<Draw> draws;
};

/// The judge's side of a student's code. A test reads as if the functions were local.
class Subject {
public:
    virtual ~Subject() = default;

    /// Sends one request and returns what became of it; never throws for the student's faults.
    protocol::Answer ask(const protocol::Request& request);

    /// Calls a function of the harness, in a process of its own. Throws SubjectFailure when no
    /// value of type R comes back.
    template <class R, class... A>
    R call(const std::string& function, const A&... arguments) {
        return decodeOr<R>(function, [&] {
            return askOrGiveUp(makeRequest(protocol::RequestKind::call, function,
                                           protocol::encode(arguments...)))
                .payload;
        });
    }

    /// The same for a function that needs an OpenGL context: it runs in the drawing process.
    template <class R, class... A>
    R shade(const std::string& function, const A&... arguments) {
        return decodeOr<R>(function, [&] { return draw(function, false, arguments...).value; });
    }

    /// The same, with all draw calls made meanwhile.
    template <class R, class... A>
    Census<R> census(const std::string& function, const A&... arguments) {
        std::vector<Draw> draws;
        R result = decodeOr<R>(function, [&] {
            auto answer = draw(function, true, arguments...);
            draws = std::move(answer.calls);
            return answer.value;
        });
        return {std::move(result), std::move(draws)};
    }

    /// shade() for a test that has its own opinion of failures: nothing is thrown or recorded.
    template <class... A>
    protocol::Answer tryShade(const std::string& function, const A&... arguments) {
        return ask(
            makeRequest(protocol::RequestKind::draw, function, protocol::encode(arguments...)));
    }

    /// tryShade() of what may well be cut short, in a process of its own: what it leaves in static
    /// variables reaches no other call.
    template <class... A>
    protocol::Answer tryAlone(const std::string& function, const A&... arguments) {
        auto request =
            makeRequest(protocol::RequestKind::draw, function, protocol::encode(arguments...));
        request.alone = true;
        return ask(request);
    }

    /// Told every request and what became of it.
    std::function<void(const protocol::Request&, const protocol::Answer&)> onAnswer =
        [](const auto&, const auto&) {};
    /// Told the ids of unfilled regions that a request reached.
    std::function<void(const std::vector<std::string>&)> onTodos = [](const auto&) {};
    /// Told why a call brings no value, before SubjectFailure is thrown.
    std::function<void(const Verdict&)> onFailure = [](const auto&) {};

    std::uint32_t callTimeoutMs = 2000;
    std::uint32_t outputBytes = 65536;
    /// For all requests together. What comes after it is not asked and answered by a fault: no
    /// right program on a machine that is not starved takes so long.
    double patienceSeconds = std::numeric_limits<double>::infinity();

protected:
    virtual protocol::Answer answerTo(protocol::Request request) = 0;

private:
    [[noreturn]] void giveUp(const Verdict& why);
    protocol::Request makeRequest(protocol::RequestKind kind, const std::string& function,
                                  protocol::Bytes arguments) const;
    protocol::Answer askOrGiveUp(const protocol::Request& request);

    template <class... A>
    protocol::DrawAnswer draw(const std::string& function, bool census, const A&... arguments) {
        auto request =
            makeRequest(protocol::RequestKind::draw, function, protocol::encode(arguments...));
        request.census = census;
        return protocol::decodeDrawAnswer(askOrGiveUp(request).payload);
    }

    template <class R, class GetBytes>
    R decodeOr(const std::string& function, GetBytes getBytes) {
        try {
            const protocol::Bytes bytes = getBytes();
            return protocol::decode<R>(bytes);
        } catch (const protocol::ProtocolError& error) {
            giveUp({Status::graderError, function + ": " + error.what()});
        }
    }

    double spentSeconds_ = 0;
    std::vector<std::string> timedOut_;  ///< not called again: one endless loop costs one time-out
};

/// A subject in a process of its own.
///
/// `command` starts the runner (with its sandbox); the number of the descriptor for the judge is
/// appended to it. The runner is started at the first request, and again when it ends. `limits`: of
/// the cgroup that the command enters; a request during which the kernel stepped in there is
/// answered so, whatever the runner said or whether it lived to say it.
std::unique_ptr<Subject> startSubject(std::vector<std::string> command, KernelLimits limits = {});

}  // namespace judge
