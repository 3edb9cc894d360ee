// What the frames and the window of this chapter show.
#pragma once

#include <glm/glm.hpp>

#include "Scene.h"

namespace course {

/// Where a picture is taken from; up is the y axis.
struct Viewpoint {
    glm::vec3 eye, target;
};
inline const Viewpoint front{{1.6f, 2.1f, 5.0f}, {0.0f, 0.95f, 0.0f}};  // where the window starts
inline const Viewpoint fromAbove{{-1.3f, 5.4f, -2.4f}, {0.0f, 0.7f, 0.1f}};
inline const Viewpoint atTheTable{{2.4f, 2.2f, 3.6f}, {0.0f, 0.55f, 0.0f}};

/// Which shader colours the surfaces.
enum class Look {
    normals,    // by their normals, shaders/normal.frag: the frames
    materials,  // by their materials, shaders/material.frag
};

/// Compiles the scene's shader and puts it to use. Needs a current context; throws cg::Error.
void use(Look look, Scene& scene);

/// Puts the camera at a place, with the lens of the pictures.
void look(Scene& scene, const Viewpoint& from);

/// Sets what Scene::draw finds ready: an empty picture, the shader in use, the camera's matrices,
/// the shader's view and projection, and its lights. `aspect` is width / height.
void prepare(Scene& scene, float aspect);

}  // namespace course
