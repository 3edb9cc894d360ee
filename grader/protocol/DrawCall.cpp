#include "protocol/DrawCall.h"

namespace protocol {

namespace {

/// Numbers of one call on the wire: the matrix, four colours, the shininess.
constexpr std::size_t kFloats = 16 + 4 * 4 + 1;
constexpr std::size_t kCallBytes = 4 + 4 + 1 + kFloats * sizeof(float);

}  // namespace

Bytes encodeDrawAnswer(const DrawAnswer& answer) {
    ByteWriter out;
    out.blob(answer.value);
    out.number(static_cast<std::uint32_t>(answer.calls.size()));
    for (const DrawCall& call : answer.calls) {
        out.number(call.vertexArray);
        out.number(call.count);
        out.number(static_cast<std::uint8_t>(call.hasMaterial));
        out.raw(&call.modelview, sizeof call.modelview);
        for (const glm::vec4* colour :
             {&call.ambient, &call.diffuse, &call.specular, &call.emision})
            out.raw(colour, sizeof *colour);
        out.number(call.shininess);
    }
    return out.take();
}

DrawAnswer decodeDrawAnswer(std::span<const std::uint8_t> bytes) {
    ByteReader in(bytes);
    DrawAnswer answer;
    answer.value = in.blob();
    const auto count = in.number<std::uint32_t>();
    if (std::size_t(count) * kCallBytes != in.left())
        throw ProtocolError("a census of another length than it says");
    answer.calls.resize(count);
    for (DrawCall& call : answer.calls) {
        call.vertexArray = in.number<std::uint32_t>();
        call.count = in.number<std::int32_t>();
        call.hasMaterial = in.number<std::uint8_t>() != 0;
        in.raw(&call.modelview, sizeof call.modelview);
        for (glm::vec4* colour : {&call.ambient, &call.diffuse, &call.specular, &call.emision})
            in.raw(colour, sizeof *colour);
        call.shininess = in.number<float>();
    }
    return answer;
}

}  // namespace protocol
