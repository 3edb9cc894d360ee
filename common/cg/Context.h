#pragma once

#include <cg/Pixels.h>

#include <string>

namespace cg {

/// An OpenGL 3.3 core context with a framebuffer of its own. Providers: OsMesaContext (memory, no
/// screen), EglContext (the same where there is no OSMesa) and GlfwContext (a window). A context
/// belongs to the thread that makes it current.
class Context {
public:
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context();

    /// "osmesa", "egl" or "glfw".
    virtual const char* provider() const = 0;

    /// Directs the GL calls of this thread to this context. Throws cg::Error.
    virtual void makeCurrent() = 0;

    /// Entry point of a GL function as the driver knows it ("glReadPixels"); nullptr when missing.
    virtual void* function(const char* name) const = 0;

    /// Size of the framebuffer in pixels, which on a dense screen is larger than the window.
    int width() const { return width_; }
    int height() const { return height_; }

    /// Gives a context in memory a framebuffer of another size, its content undefined; shaders and
    /// buffers stay. The context is current afterwards. Throws cg::Error for a window, which only
    /// its user resizes.
    virtual void resizeFramebuffer(int width, int height);

    /// GL_VERSION and GL_RENDERER. The context must be current; so it is for all below.
    std::string version() const;
    std::string renderer() const;

    /// Waits until drawing is finished and reads the whole framebuffer (of a window: the back
    /// buffer). Throws cg::Error when the context is not current or GL refuses. Errors that
    /// earlier calls left behind are not this function's: take them with errors() before.
    Pixels readPixels() const;

    /// Names of the pending GL errors, separated by ", ", and forgets them. Empty when all is well.
    std::string errors() const;

protected:
    /// Throws cg::Error unless both are 1 to maxSide.
    Context(int width, int height);

    /// The framebuffer object that holds the picture; 0 is the context's own surface.
    virtual unsigned framebuffer() const { return 0; }

    void becomeCurrent();  ///< a provider calls this when makeCurrent() succeeded
    bool isCurrent() const;
    void resize(int width, int height);

private:
    std::string text(unsigned name) const;
    void requireCurrent(const char* caller) const;

    unsigned id_;
    int width_;
    int height_;
};

/// Number of the context that is current on this thread; 0 when none is, or one that did not come
/// from here. No number is used twice in a process.
unsigned currentContextId() noexcept;

}  // namespace cg
