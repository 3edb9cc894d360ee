#include "subject/Subject.h"

#include <algorithm>
#include <chrono>

namespace judge {

protocol::Answer Subject::ask(const protocol::Request& request) {
    protocol::Answer answer;
    if (spentSeconds_ < patienceSeconds) {
        const auto begun = std::chrono::steady_clock::now();
        answer = answerTo(request);
        spentSeconds_ +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    } else {
        answer.outcome = protocol::Outcome::faulty;
        answer.detail = "the calls before it took " + std::to_string(int(spentSeconds_)) +
                        " s together, which is more than all may take";
    }
    onAnswer(request, answer);
    return answer;
}

void Subject::giveUp(const Verdict& why) {
    onFailure(why);
    throw SubjectFailure(why);
}

protocol::Request Subject::makeRequest(protocol::RequestKind kind, const std::string& function,
                                       protocol::Bytes arguments) const {
    protocol::Request request;
    request.kind = kind;
    request.name = function;
    request.arguments = std::move(arguments);
    request.timeoutMs = callTimeoutMs;
    request.outputBytes = outputBytes;
    return request;
}

protocol::Answer Subject::askOrGiveUp(const protocol::Request& request) {
    if (std::find(timedOut_.begin(), timedOut_.end(), request.name) != timedOut_.end())
        giveUp(
            {Status::timeout, request.name + " was not called again: it ran out of time before"});
    protocol::Answer answer = ask(request);
    onTodos(answer.todos);
    if (answer.outcome == protocol::Outcome::timeout)
        timedOut_.push_back(request.name);
    if (answer.outcome != protocol::Outcome::ok)
        giveUp(explain(request.name, request, answer));
    return answer;
}

}  // namespace judge
