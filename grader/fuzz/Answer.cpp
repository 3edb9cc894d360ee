// The judge's side of the wire: all that a runner may answer, whole messages first, then each kind
// of payload.

#include <sys/socket.h>
#include <unistd.h>

#include "Fuzz.h"
#include "protocol/AnyValue.h"
#include "protocol/DrawCall.h"
#include "protocol/Message.h"
#include "protocol/Value.h"
#include "subject/Evidence.h"
#include "subject/Status.h"

namespace {

using protocol::Bytes;

template <class Read>
void mayRefuse(Read&& read) {
    try {
        read();
    } catch (const protocol::ProtocolError&) {
    }
}

/// What a test that expects this type does.
template <class T>
void decodeAs(const Bytes& payload) {
    mayRefuse([&] { protocol::decode<T>(payload); });
}

void readPayload(const protocol::Answer& answer) {
    protocol::Request request;
    for (const auto kind : {protocol::RequestKind::call, protocol::RequestKind::draw})
        for (const bool census : {false, true}) {
            request.kind = kind;
            request.census = census;
            const auto evidence = judge::evidenceOf(request, answer);
            fuzz::require(evidence.numbers.size() <= judge::kMostNumbers, "evidence is small");
        }
    if (answer.outcome != protocol::Outcome::ok)
        judge::explain("f", request, answer);
    mayRefuse([&] { protocol::decodeGraphics(answer.payload); });
    decodeAs<bool>(answer.payload);
    decodeAs<glm::mat4>(answer.payload);
    decodeAs<std::vector<glm::vec3>>(answer.payload);
    decodeAs<std::vector<bool>>(answer.payload);
    decodeAs<std::tuple<int, float, std::vector<glm::mat3>>>(answer.payload);
}

/// As much of a message as a socket holds at once.
void readFromSocket(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kHeld = 32768;
    int ends[2];
    fuzz::require(socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0, "there are sockets");
    fuzz::require(write(ends[1], data, std::min(size, kHeld)) >= 0, "a socket can be written to");
    close(ends[1]);
    Bytes body;
    protocol::readMessage(ends[0], protocol::kAnswerMagic, protocol::kLargestAnswer, 1000, body);
    close(ends[0]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    readFromSocket(data, size);
    mayRefuse([&] {
        const protocol::Answer answer = protocol::decodeAnswer({data, size});
        fuzz::require(protocol::encodeAnswer(answer) == Bytes(data, data + size),
                      "an answer comes back as it was");
        readPayload(answer);
    });
    protocol::Answer bare;
    bare.payload.assign(data, data + size);
    readPayload(bare);
    return 0;
}
