// What the frames and the window of this chapter show: boxes at many distances. A long beam
// reaches through the near and the far plane, and two plates hide parts of each other.
#pragma once

#include <cg/NormalShader.h>

#include <glm/glm.hpp>
#include <vector>

#include "Cube.h"

namespace course {

// Where the notes' viewer starts, code 7.3, and its lens.
inline const glm::vec3 viewerEye(0.0f, 0.2f, 5.0f);
inline const glm::vec3 viewerTarget(0.0f, 0.2f, 0.0f);
inline const glm::vec3 viewerUp(0.0f, 1.0f, 0.0f);
constexpr float viewerFovyDegrees = 30.0f;
constexpr float viewerNear = 0.01f;
constexpr float viewerFar = 100.0f;

// The window without perspective shows orthographic(2, aspect, -10, 10). With aspect 4 / 3 that is
// the notes' proj_default (code 7.3): the picture is 2 units high, whatever the distance.
constexpr float viewerOrthoHeight = 2.0f;
constexpr float viewerOrthoNear = -10.0f;
constexpr float viewerOrthoFar = 10.0f;

class Scene {
public:
    /// Loads the shader and builds the cube. Call it once, with a GL context current.
    /// Throws cg::Error when a shader file is missing or does not compile.
    void init();

    /// Clears the picture and draws everything.
    void draw(const glm::mat4& view, const glm::mat4& projection);

    /// Clears the picture and draws a small cube at each of these points, the last one twice as
    /// large.
    void drawPoints(const std::vector<glm::vec3>& points, const glm::mat4& view,
                    const glm::mat4& projection);

private:
    void begin(const glm::mat4& projection);
    void box(const glm::mat4& placement, const glm::vec3& size);

    Cube cube_;
    NormalShader shader_;
};

}  // namespace course
