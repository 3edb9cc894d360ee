#pragma once

#include "Geometry.h"

#include <glm/glm.hpp>

/// A square in the plane z = 0 with its sides along the axes (section 4.1.2); counter-clockwise
/// seen from +z. Attribute 0: position (2 floats); attribute 1, if coloured: RGB (3 floats).
class Square : public Geometry {
public:
    using Geometry::init;

    /// Without colours.
    void init(const glm::vec2 center, const GLfloat sidelength);

    /// With one colour per corner, counter-clockwise from the lower left one.
    void init(const glm::vec2 center, const GLfloat sidelength, const glm::vec3 color0,
              const glm::vec3 color1, const glm::vec3 color2, const glm::vec3 color3);
};
