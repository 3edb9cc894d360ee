#pragma once

#include <cg/Context.h>

namespace cg {

/// A framebuffer object of RGBA8 with 24 bits of depth and 8 of stencil, made and bound through a
/// context's entry points. What contexts in memory draw into: the surfaces that providers bring
/// along are rasterised the other way up by some of them, and edges would fall on other pixels.
/// The context must be current for all but the destructor, which leaves the objects to it.
class FramebufferObject {
public:
    explicit FramebufferObject(const Context& context) : context_(context) {}
    FramebufferObject(const FramebufferObject&) = delete;
    FramebufferObject& operator=(const FramebufferObject&) = delete;

    /// A fresh one of the context's size in place of the former; its viewport is all of it.
    /// Throws cg::Error when GL refuses.
    void make();

    unsigned name() const { return framebuffer_; }

private:
    const Context& context_;
    unsigned framebuffer_ = 0;
    unsigned renderbuffers_[2] = {};
};

}  // namespace cg
