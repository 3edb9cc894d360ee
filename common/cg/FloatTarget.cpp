#include <cg/Error.h>
#include <cg/FloatTarget.h>

#include <string>

namespace cg {

/// The constructor that follows delegates to this one: where it throws, the destructor puts
/// everything back.
FloatTarget::FloatTarget() {
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &formerFramebuffer_);
    glGetIntegerv(GL_VIEWPORT, formerViewport_);
    glGetFloatv(GL_COLOR_CLEAR_VALUE, formerClear_);
    formerDepthTest_ = glIsEnabled(GL_DEPTH_TEST);
    formerBlend_ = glIsEnabled(GL_BLEND);
}

FloatTarget::FloatTarget(int width, int height) : FloatTarget() {
    width_ = width;
    height_ = height;
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error("GL gives no framebuffer of 32-bit floats of " + std::to_string(width) + " x " +
                    std::to_string(height));
    }
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
}

FloatTarget::~FloatTarget() {
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(formerFramebuffer_));
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
    glViewport(formerViewport_[0], formerViewport_[1], formerViewport_[2], formerViewport_[3]);
    glClearColor(formerClear_[0], formerClear_[1], formerClear_[2], formerClear_[3]);
    if (formerDepthTest_ == GL_TRUE) {
        glEnable(GL_DEPTH_TEST);
    }
    if (formerBlend_ == GL_TRUE) {
        glEnable(GL_BLEND);
    }
}

std::vector<glm::vec4> FloatTarget::read() const {
    std::vector<glm::vec4> values(static_cast<std::size_t>(width_) *
                                  static_cast<std::size_t>(height_));
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, values.data());
    return values;
}

}  // namespace cg
