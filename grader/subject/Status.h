#pragma once

#include <string>

#include "protocol/Message.h"

/// What became of a check, and how that is said.
namespace judge {

enum class Status {
    pass,
    partial,
    fail,
    notImplemented,
    skipped,
    pending,  ///< a person judges it
    buildError,
    crash,
    timeout,
    memory,
    output,
    tampered,
    graderError,  ///< the grader's own fault; never costs points silently
};

/// "pass", "not_implemented", …: the words of the result document.
const char* toString(Status status);
/// Throws std::invalid_argument for any other word.
Status statusFromString(const std::string& word);

struct Verdict {
    Status status;
    std::string message;  ///< one sentence for the student
};

/// Whether a verdict says that the process was killed, and not by one of its limits: it may have
/// been in the way of others when the machine ran out of memory, or have done it itself.
bool wasKilledFromOutside(const Verdict& verdict);

/// What an answer other than `ok` means for the check that asked. `what` names the function or
/// frame as the student knows it.
Verdict explain(const std::string& what, const protocol::Request& request,
                const protocol::Answer& answer);

}  // namespace judge
