#include <protocol/DrawCall.h>
#include <protocol/Message.h>
#include <protocol/Value.h>
#include <unistd.h>

// An answer as the runner frames it, to a call that draws: a vector of no vec3.
inline void answerWithoutValues() {
    protocol::ByteWriter draw;
    draw.blob(protocol::Bytes{0x25, 0, 0, 0, 0});
    draw.number(std::uint32_t(0));
    protocol::ByteWriter answer;
    for (int i = 0; i < 16; ++i)
        answer.number(std::uint8_t(0));
    answer.number(std::uint8_t(0));
    answer.number(std::int32_t(0));
    answer.number(std::uint32_t(0));
    answer.number(std::uint32_t(0));
    answer.blob(draw.take());
    const protocol::Bytes body = answer.take();
    protocol::ByteWriter message;
    message.number(std::uint32_t(0x4e414743));
    message.number(std::uint32_t(body.size()));
    message.raw(body.data(), body.size());
    const protocol::Bytes bytes = message.take();
    (void)!write(3, bytes.data(), bytes.size());
    for (;;)
        pause();
}
