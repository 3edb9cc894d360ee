#include "subject/Status.h"

#include <fmt/format.h>

#include <csignal>
#include <stdexcept>
#include <utility>

namespace judge {

namespace {

constexpr std::pair<Status, const char*> kWords[] = {
    {Status::pass, "pass"},
    {Status::partial, "partial"},
    {Status::fail, "fail"},
    {Status::notImplemented, "not_implemented"},
    {Status::skipped, "skipped"},
    {Status::pending, "pending"},
    {Status::buildError, "build_error"},
    {Status::crash, "crash"},
    {Status::timeout, "timeout"},
    {Status::memory, "memory"},
    {Status::output, "output"},
    {Status::tampered, "tampered"},
    {Status::graderError, "grader_error"},
};

constexpr const char* kKilled = "SIGKILL (stopped from outside, most likely for its memory)";

std::string signalName(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "SIGSEGV (memory that is not yours, or endless recursion)";
        case SIGBUS:
            return "SIGBUS (memory that is not there)";
        case SIGFPE:
            return "SIGFPE (division of an integer by zero)";
        case SIGILL:
            return "SIGILL (a function that returns a value must not end without one)";
        case SIGABRT:
            return "SIGABRT (abort or a failed assert)";
        case SIGKILL:
            return kKilled;
        default:
            return fmt::format("signal {}", signal);
    }
}

/// A report's sentence has an end, whatever a student's exception says.
std::string shortened(const std::string& text) {
    constexpr std::size_t kMostBytes = 400;
    if (text.size() <= kMostBytes)
        return text;
    std::size_t end = kMostBytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
        --end;  // not through the middle of a character
    return text.substr(0, end) + "…";
}

}  // namespace

const char* toString(Status status) {
    for (const auto& [each, word] : kWords)
        if (each == status)
            return word;
    return "grader_error";
}

Status statusFromString(const std::string& word) {
    for (const auto& [status, each] : kWords)
        if (word == each)
            return status;
    throw std::invalid_argument("no status is called " + word);
}

bool wasKilledFromOutside(const Verdict& verdict) {
    return verdict.status == Status::crash && verdict.message.ends_with(kKilled);
}

Verdict explain(const std::string& what, const protocol::Request& request,
                const protocol::Answer& answer) {
    using protocol::Outcome;
    const std::string detail = shortened(answer.detail);
    const std::string place = detail.empty() ? "" : " in " + detail;
    switch (answer.outcome) {
        case Outcome::ok:
            break;
        case Outcome::missing:
            return {Status::notImplemented, detail};
        case Outcome::shader:
            return {Status::buildError, answer.detail};
        case Outcome::exception:
            return {Status::crash, fmt::format("{} threw an exception: {}", what, detail)};
        case Outcome::crash:
            if (answer.code == 0)
                return {Status::crash, fmt::format("{} {}", what, detail)};
            return {Status::crash,
                    fmt::format("{} crashed{} with {}", what, place, signalName(answer.code))};
        case Outcome::exited:
            if (answer.code == 0)
                return {Status::tampered, what +
                                              " ended the whole program with exit status 0 "
                                              "instead of returning"};
            return {Status::crash, fmt::format("{} ended the whole program with exit status {}",
                                               what, answer.code)};
        case Outcome::timeout:
            if (!detail.empty())
                return {Status::timeout, fmt::format("{} {}", what, detail)};
            return {Status::timeout, fmt::format("{} did not finish within {:g} s: look for a loop "
                                                 "that never ends",
                                                 what, request.timeoutMs / 1000.0)};
        case Outcome::memory:
            return {Status::memory, fmt::format("{} asked for more memory than it may have{}", what,
                                                detail.empty() ? "" : " (" + detail + ")")};
        case Outcome::output:
            if (!detail.empty())
                return {Status::output, fmt::format("{} {}", what, detail)};
            return {Status::output,
                    fmt::format("{} printed more than {} KiB", what, request.outputBytes / 1024)};
        case Outcome::tampered:
            return {Status::tampered, what + ": " + detail};
        case Outcome::unknown:
        case Outcome::faulty:
            return {Status::graderError, detail};
    }
    return {Status::graderError, what + ": an answer that is no failure was explained as one"};
}

}  // namespace judge
