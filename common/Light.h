#pragma once

#include <glm/glm.hpp>

/// A light (sections 10.2 and 10.4): homogeneous position in world coordinates, w = 0 for a light
/// at infinity, and linear RGB with an alpha of 1.
struct Light {
    glm::vec4 position = glm::vec4(0.0f, 0.0f, 1.0f, 0.0f);
    glm::vec4 color = glm::vec4(1.0f, 1.0f, 1.0f, 1.0f);
};
