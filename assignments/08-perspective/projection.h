// Projections and homogeneous coordinates (chapter 8). Provided; it is not handed in.
#pragma once

#include <glm/glm.hpp>

/// The orthographic projection of the box that is `height` high and aspect * height wide, centred
/// on the camera's axis, from the depth `n` to the depth `f` in front of the camera: camera z from
/// -n to -f. The box lands on [-1, 1]^3, near on -1. height, aspect > 0 and n < f; n may be
/// negative, then the box begins behind the camera.
glm::mat4 orthographic(const float height, const float aspect, const float n, const float f);

/// The homogeneous coordinates (p, 1) of the point p, eq. (8.6).
glm::vec4 homogenise(const glm::vec3 p);

/// The point that p stands for: xyz / w, eq. (8.8). For w = 0, a point at infinity, xyz as it is.
glm::vec3 dehomogenise(const glm::vec4 p);

/// The point at infinity in this direction: (direction, 0). The direction is not normalised.
glm::vec4 pointAtInfinity(const glm::vec3 direction);

/// Whether p is a point at infinity, that is, whether its w is 0.
bool isAtInfinity(const glm::vec4 p);
