// What the frames and the window of this chapter show: solids of several materials on a table,
// under lights that are near, far or at infinity.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "Camera.h"
#include "Cube.h"
#include "Light.h"
#include "Material.h"
#include "Obj.h"
#include "Sphere.h"
#include "SurfaceShader.h"
#include "Torus.h"

namespace course {

/// SurfaceShader with the uniforms that this chapter adds.
struct LightingShader : SurfaceShader {
    glm::vec3 attenuation = glm::vec3(1.0f, 0.0f, 0.0f);  ///< c0, c1, c2 of (10.14)
    float exposure = 1.0f;                                ///< A of (10.2)
    float gamma = 1.0f;                                   ///< of (10.2)

    /// Hands everything to GL; the program must be in use.
    void setAllUniforms();
};

/// A shape of the set, put somewhere and given a material.
struct Item {
    Geometry* shape;
    glm::mat4 model;  ///< model to world coordinates
    Material* material;
};

/// Red, green and blue for `ambient`, `diffuse`, `specular` and `emision`; alpha 1.
Material material(const glm::vec3& ambient, const glm::vec3& diffuse, const glm::vec3& specular,
                  const glm::vec3& emision, float shininess);
Light light(const glm::vec4& position, const glm::vec3& color);

class Set {
public:
    Sphere sphere;
    Torus torus;
    Cube cube;
    Obj teapot;
    LightingShader shader;
    std::vector<Light> stale;  ///< what slots beyond the lights in use hold; else they are black

    /// Loads the shader "shaders/lighting.frag" and builds the shapes; once, with a context
    /// current. Throws cg::Error when a file is missing or does not compile.
    void init();

    /// Clears the picture and draws the items. Uses shader's attenuation, exposure and gamma.
    void draw(const glm::mat4& view, const glm::mat4& projection, const std::vector<Light>& lights,
              const std::vector<Item>& items);
};

/// The still life of the window and of the rich frames: table, teapot, sphere, stretched torus and
/// a small glowing cube at each lamp. Matrices are in world coordinates, y is up.
class StillLife {
public:
    static inline const glm::vec3 target{0.1f, 0.15f, 0.05f};
    static constexpr float fovyDegrees = 33.0f;

    /// Puts a camera where the window starts.
    static void place(Camera& camera);

    /// Matt things show no highlight, and so none where a light does not reach: the notes leave
    /// open whether there is one.
    enum class Finish { shiny, matt };

    explicit StillLife(Set& set, Finish finish = Finish::shiny) : set_(set), finish_(finish) {}

    /// Lamps at finite places get a glowing cube; lights at infinity do not show.
    void draw(const glm::mat4& view, const glm::mat4& projection, const std::vector<Light>& lamps);

    /// A light at infinity, one lamp with w = 1 and one with w = 2, all coloured, the last not
    /// white.
    static std::vector<Light> lamps();

private:
    Set& set_;
    Finish finish_;
};

}  // namespace course
