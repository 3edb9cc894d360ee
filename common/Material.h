#pragma once

#include <glm/glm.hpp>

/// What a surface does with light (section 9.1.1): linear RGB and an alpha of 1.
/// Spelled as in the lecture notes.
struct Material {
    glm::vec4 ambient = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    glm::vec4 diffuse = glm::vec4(1.0f, 1.0f, 1.0f, 1.0f);
    glm::vec4 specular = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    glm::vec4 emision = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    float shininess = 10.0f;  ///< exponent of the highlight, > 0
};
