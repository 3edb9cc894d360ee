// The runner: a small sandboxed program that hosts a student's code.
//
// Theory of operation. The judge starts `runner SUBJECT RESOURCES PROVIDER DESCRIPTOR` in a sandbox
// and sends requests over the inherited socket. This process, the parent, only forks and watches:
// it never loads the subject, so nothing a student wrote can reach the judge's socket or a later
// request. A call gets a fresh child, and so does a draw that is asked for alone. Frames and the
// other draws share one child, because an OpenGL context is dear; it is replaced when it dies, and
// when an exception cut a request short: what that left in static variables is nobody else's. Every
// child loads the subject itself, so even a crash in a static initialiser costs one request and is
// reported with its line.

#include <signal.h>
#include <sys/prctl.h>

#include <cstdlib>
#include <iostream>
#include <memory>

#include "runner/Child.h"

namespace {

using protocol::Answer;
using protocol::Bytes;
using protocol::Outcome;
using protocol::Request;
using protocol::RequestKind;

Answer serve(const Request& request, const runner::SubjectFiles& files,
             std::unique_ptr<runner::Child>& frameChild) {
    if (request.kind == RequestKind::call || (request.kind == RequestKind::draw && request.alone))
        return runner::Child(files).ask(request);
    if (!frameChild || !frameChild->alive())
        frameChild = std::make_unique<runner::Child>(files);
    Answer answer = frameChild->ask(request);
    if (answer.outcome == Outcome::exception)
        frameChild.reset();
    return answer;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::cerr << "usage: runner SUBJECT RESOURCES PROVIDER DESCRIPTOR\n"
                     "Started by the grader, not by hand.\n";
        return 2;
    }
    const runner::SubjectFiles files{argv[1], argv[2], argv[3]};
    const int judge = std::atoi(argv[4]);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    prctl(PR_SET_DUMPABLE, 0);  // no child may write to this process' memory
    signal(SIGPIPE, SIG_IGN);

    std::unique_ptr<runner::Child> frameChild;
    Bytes body;
    while (protocol::readMessage(judge, protocol::kRequestMagic, protocol::kLargestRequest, -1,
                                 body) == protocol::ReadStatus::ok) {
        const Request request = protocol::decodeRequest(body);
        Answer answer;
        try {
            answer = serve(request, files, frameChild);
        } catch (const std::exception& error) {
            answer.nonce = request.nonce;
            answer.outcome = Outcome::faulty;
            answer.detail = error.what();
        }
        if (!protocol::writeAll(
                judge, protocol::framed(protocol::kAnswerMagic, protocol::encodeAnswer(answer))))
            break;
    }
    return 0;
}
