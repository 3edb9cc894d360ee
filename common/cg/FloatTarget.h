#pragma once

#include <cg/gl.h>

#include <glm/glm.hpp>
#include <vector>

namespace cg {

/// A framebuffer of unclamped 32-bit floats, cleared to 0 and bound for as long as it lives, with
/// its viewport and without depth test or blending. Then all is as it was before.
/// Throws cg::Error when GL refuses it.
class FloatTarget {
public:
    FloatTarget(int width, int height);
    FloatTarget(const FloatTarget&) = delete;
    FloatTarget& operator=(const FloatTarget&) = delete;
    ~FloatTarget();

    /// width x height values, GL's order: row 0 at the bottom.
    std::vector<glm::vec4> read() const;

private:
    FloatTarget();

    int width_ = 0, height_ = 0;
    GLuint framebuffer_ = 0, texture_ = 0;
    GLint formerFramebuffer_ = 0, formerViewport_[4] = {};
    GLfloat formerClear_[4] = {};
    GLboolean formerDepthTest_ = GL_FALSE, formerBlend_ = GL_FALSE;
};

}  // namespace cg
