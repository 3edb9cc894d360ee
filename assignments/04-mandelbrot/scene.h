// What the window and the frames of this chapter show: your shader on a square over the picture.
#pragma once

// In angle brackets, so that the window of the solution finds the solution's.
#include <MandelbrotShader.h>

#include "Square.h"

namespace course {

/// Set shader.center, shader.zoom and shader.maxiter, then draw().
class Scene {
public:
    /// Reads, compiles and starts the shader, and builds the square. Call it once, with a GL
    /// context current. Throws cg::Error when a shader file is missing or does not compile.
    void init();

    /// Fills the viewport; P = (-1, -1) is its lower left corner.
    void draw();

    MandelbrotShader shader;

private:
    Square square_;
};

}  // namespace course
