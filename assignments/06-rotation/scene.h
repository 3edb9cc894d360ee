// What the frames and the window of this chapter show: a lopsided body of boxes that is turned
// about the origin, and a whirl of small cubes that shows what [u x] does to points.
#pragma once

#include <cg/NormalShader.h>

#include <glm/glm.hpp>

#include "Cube.h"

namespace course {

class Scene {
public:
    /// Loads the shader and builds the cube. Call it once, with a GL context current.
    /// Throws cg::Error when a shader file is missing or does not compile.
    void init();

    /// Clears the picture and draws the body after `pose`, a matrix that acts on its vertices.
    /// `aspect` is width / height of the viewport; the picture is always 2.6 units high.
    void drawBody(const glm::mat3& pose, float aspect);

    /// Clears the picture and draws three bodies side by side, each after its own matrix.
    void drawThreeBodies(const glm::mat3 (&poses)[3], float aspect);

    /// Clears the picture and draws a ring of cubes with a small cube ahead of each, at p + v / 3
    /// for v = velocity * p. With velocity = [u x] the small cubes run round the axis u.
    void drawWhirl(const glm::mat3& velocity, float aspect);

private:
    void begin(float aspect);
    void body(const glm::mat4& placement);
    void box(const glm::mat4& placement, const glm::vec3& center, const glm::vec3& size);

    Cube cube_;
    NormalShader shader_;
};

}  // namespace course
