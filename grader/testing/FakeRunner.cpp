// A runner that answers as it is told: `fake_runner MODE DESCRIPTOR`. It never loads anything.

#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

#include "protocol/Message.h"
#include "protocol/Value.h"

using protocol::Answer;
using protocol::Bytes;
using protocol::Outcome;
using protocol::Request;

namespace {

Answer answerTo(const Request& request, const std::string& mode) {
    Answer answer;
    answer.nonce = request.nonce;
    answer.payload = protocol::encode(42);
    answer.todos = {"rotation"};
    if (mode == "wrong-nonce")
        answer.nonce[1] ^= 1;
    if (mode == "no-value")
        answer.payload = protocol::encode(true);
    if (mode == "timeout" || mode == "timeout-of-one") {
        const bool this_one = mode == "timeout" || request.name == "slow";
        answer.outcome = this_one ? Outcome::timeout : Outcome::ok;
    }
    if (mode == "crash") {
        answer.outcome = Outcome::crash;
        answer.code = 11;
        answer.detail = "turn, Camera.cpp:12";
    }
    if (mode == "process-id")
        answer.payload = protocol::encode(static_cast<int>(getpid()));
    return answer;
}

void send(int judge, const Bytes& bytes) {
    if (!protocol::writeAll(judge, bytes))
        std::exit(0);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3)
        return 2;
    const std::string mode = argv[1];
    const int judge = std::atoi(argv[2]);
    Bytes body;
    while (protocol::readMessage(judge, protocol::kRequestMagic, protocol::kLargestRequest, -1,
                                 body) == protocol::ReadStatus::ok) {
        const Request request = protocol::decodeRequest(body);
        if (mode == "dies") {
            std::cerr << "libOSMesa is not here\n";
            return 3;
        }
        if (mode == "hangs")
            for (;;)
                pause();
        if (mode == "eats")
            for (;;)
                std::memset(new char[1 << 20], 1, 1 << 20);
        if (mode == "garbage")
            send(judge, Bytes(64, 'x'));
        else if (mode == "short-body")
            send(judge, protocol::framed(protocol::kAnswerMagic, Bytes(5, 0)));
        else if (mode == "huge")
            send(judge, {'C', 'G', 'A', 'N', 0xff, 0xff, 0xff, 0xff});
        else
            send(judge, protocol::framed(protocol::kAnswerMagic,
                                         protocol::encodeAnswer(answerTo(request, mode))));
        if (mode == "answers-twice")
            send(judge, protocol::framed(protocol::kAnswerMagic,
                                         protocol::encodeAnswer(answerTo(request, mode))));
        if (mode == "answers-once")
            return 0;
    }
    return 0;
}
