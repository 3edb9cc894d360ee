#include "subject/Subject.h"

#include <algorithm>

namespace judge {

void Subject::giveUp(const Verdict& why) {
    onFailure(why);
    throw SubjectFailure(why);
}

protocol::Answer Subject::askForCall(const std::string& function, protocol::Bytes arguments) {
    if (std::find(timedOut_.begin(), timedOut_.end(), function) != timedOut_.end())
        giveUp({Status::timeout, function + " was not called again: it ran out of time before"});
    protocol::Request request;
    request.kind = protocol::RequestKind::call;
    request.name = function;
    request.arguments = std::move(arguments);
    request.timeoutMs = callTimeoutMs;
    request.outputBytes = outputBytes;
    protocol::Answer answer = ask(request);
    onTodos(answer.todos);
    if (answer.outcome == protocol::Outcome::timeout)
        timedOut_.push_back(function);
    if (answer.outcome != protocol::Outcome::ok)
        giveUp(explain(function, request, answer));
    return answer;
}

}  // namespace judge
