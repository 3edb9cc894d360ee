// Parts of the complex plane that the frames and the checks of this chapter look at.
#pragma once

#include <runner/SeededValues.h>

#include <cmath>
#include <glm/glm.hpp>

namespace course {

/// What MandelbrotShader hands to GL.
struct View {
    glm::vec2 center;
    float zoom;
    int maxiter;
};

inline const View wholeSet{{0.0f, 0.0f}, 2.0f, 50};
inline const View seahorses{{-0.752f, 0.114f}, 0.06f, 150};
inline const View crown{{-0.12f, 0.83f}, 0.3f, 60};
inline const View fewSteps{{-0.6f, -0.35f}, 0.9f, 12};  // below the real axis

/// A place on the rim of the largest body, where many levels meet; never near the real axis, in
/// which the set is its own mirror image. maxiter is even, as in the window: a palette that goes
/// there and back, such as sin(pi I / maxiter), has its turning point on a level of its own.
inline View drawnView(SeededValues& values) {
    const float angle = values.uniform(0.7f, 2.4f);
    const glm::vec2 rim(0.5f * std::cos(angle) - 0.25f * std::cos(2.0f * angle),
                        0.5f * std::sin(angle) - 0.25f * std::sin(2.0f * angle));
    const float side = values.uniform(-1.0f, 1.0f) < 0.0f ? -1.0f : 1.0f;
    const float zoom = values.uniform(0.15f, 0.35f);
    const int maxiter = 2 * static_cast<int>(values.uniform(13.0f, 35.0f));
    return {{rim.x, side * rim.y}, zoom, maxiter};
}

}  // namespace course
