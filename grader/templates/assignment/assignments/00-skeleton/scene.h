// What the frames and the window of this chapter show: a polygon on a grey sheet.
#pragma once

#include <Shader.h>

#include <glm/glm.hpp>
#include <vector>

#include "Square.h"

namespace course {

/// A filled polygon, red at its first corner and blue at its last.
class Polygon : public Geometry {
public:
    using Geometry::init;
    void init(const std::vector<glm::vec2>& corners);
};

// AUTHOR: what is drawn, shared by app.cpp and harness.cpp. It calls no function of the student's:
// it is given what they return. A picture must show something before anything is implemented.
class Scene {
public:
    /// Loads the shader and builds the sheet. Call it once, with a GL context current.
    /// Throws cg::Error when a shader file is missing or does not compile.
    void init();

    /// Clears the picture and draws the sheet and the polygon. `aspect` is width / height of the
    /// viewport; the picture is always 2.4 units high.
    void draw(const std::vector<glm::vec2>& corners, float aspect);

private:
    Square sheet_;
    Polygon polygon_;
    Shader shader_;
    GLint scale_ = -1;
};

}  // namespace course
