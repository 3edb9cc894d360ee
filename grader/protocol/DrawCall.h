#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "protocol/Bytes.h"

namespace protocol {

/// One draw call as the runner saw it: what was drawn, and with which uniforms of the current
/// program. A uniform that the program lacks is 0.
struct DrawCall {
    std::uint32_t vertexArray = 0;
    std::int32_t count = 0;    ///< vertices or indices
    bool hasMaterial = false;  ///< the program has at least one of the four colours
    glm::mat4 modelview{0.0f};
    glm::vec4 ambient{0.0f}, diffuse{0.0f}, specular{0.0f}, emision{0.0f};
    float shininess = 0.0f;
};

/// What a `draw` request brings: the function's value and the draw calls made meanwhile.
struct DrawAnswer {
    Bytes value;
    std::vector<DrawCall> calls;
};

Bytes encodeDrawAnswer(const DrawAnswer& answer);
/// Throws ProtocolError.
DrawAnswer decodeDrawAnswer(std::span<const std::uint8_t> bytes);

}  // namespace protocol
