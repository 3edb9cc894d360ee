// What the frames and the window of this chapter show: the notes' cube with three smaller boxes,
// so that left and right, above and below, front and back all look different.
#pragma once

#include <cg/NormalShader.h>

#include <glm/glm.hpp>

#include "Cube.h"
#include "Sphere.h"

namespace course {

// Where the notes' viewer starts, code 7.3.
inline const glm::vec3 viewerEye(0.0f, 0.2f, 5.0f);
inline const glm::vec3 viewerTarget(0.0f, 0.2f, 0.0f);
inline const glm::vec3 viewerUp(0.0f, 1.0f, 0.0f);

/// The projection of code 7.3 for a viewer without perspective: 2 units high, depth -10 to 10,
/// `aspect` = width / height. For 4 / 3 it is the notes' proj_default.
glm::mat4 projDefault(float aspect);

class Scene {
public:
    /// Loads the shader and builds the cube. Call it once, with a GL context current.
    /// Throws cg::Error when a shader file is missing or does not compile.
    void init();

    /// Clears the picture and draws everything.
    void draw(const glm::mat4& view, const glm::mat4& projection);

private:
    void box(const glm::mat4& view, const glm::vec3& center, const glm::vec3& size);

    Cube cube_;
    NormalShader shader_;
};

/// Stretched and sheared solids, coloured by what shaders/transformed_normal.vert makes of their
/// normals: red where a surface looks to the right of the camera, green upwards, blue towards it.
class NormalScene {
public:
    /// As for Scene.
    void init();
    void draw(const glm::mat4& view, const glm::mat4& projection);

private:
    Cube cube_;
    Sphere sphere_;
    NormalShader shader_;
};

}  // namespace course
