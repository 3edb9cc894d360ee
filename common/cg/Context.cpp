// GL is reached through Context::function() alone, so this file needs no GL library at link time.
#include <cg/Context.h>
#include <cg/Error.h>
#include <cg/gl.h>

#include <algorithm>
#include <atomic>

namespace cg {
namespace {

thread_local unsigned currentId = 0;

unsigned nextId() {
    static std::atomic<unsigned> last{0};
    return ++last;
}

template <class Function>
Function entry(const Context& context, const char* name) {
    void* address = context.function(name);
    if (address == nullptr) {
        throw Error(std::string("this OpenGL library has no function ") + name);
    }
    return reinterpret_cast<Function>(address);
}

std::string errorName(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        default:
            return "GL error " + std::to_string(error);
    }
}

/// Rows as GL delivers them start at the bottom; a picture starts at the top.
void flipRows(Pixels& pixels) {
    const auto rowBytes = static_cast<std::ptrdiff_t>(pixels.width) * 4;
    for (int row = 0; row < pixels.height / 2; ++row) {
        const auto upper = pixels.rgba.begin() + row * rowBytes;
        const auto lower = pixels.rgba.begin() + (pixels.height - 1 - row) * rowBytes;
        std::swap_ranges(upper, upper + rowBytes, lower);
    }
}

}  // namespace

unsigned currentContextId() noexcept {
    return currentId;
}

Context::Context(int width, int height) : id_(nextId()), width_(width), height_(height) {
    if (width < 1 || height < 1 || width > maxSide || height > maxSide) {
        throw Error("a framebuffer has 1 to " + std::to_string(maxSide) +
                    " pixels a side, asked for " + std::to_string(width) + " x " +
                    std::to_string(height));
    }
}

Context::~Context() {
    if (currentId == id_) {
        currentId = 0;
    }
}

void Context::becomeCurrent() {
    currentId = id_;
}

bool Context::isCurrent() const {
    return currentId == id_;
}

void Context::resizeFramebuffer(int, int) {
    throw Error(std::string("a framebuffer of ") + provider() +
                " cannot be resized by the program");
}

void Context::resize(int width, int height) {
    width_ = width;
    height_ = height;
}

void Context::requireCurrent(const char* caller) const {
    if (!isCurrent()) {
        throw Error(std::string(caller) + ": another context or none is current; call makeCurrent");
    }
}

std::string Context::text(unsigned name) const {
    const GLubyte* found = entry<PFNGLGETSTRINGPROC>(*this, "glGetString")(name);
    return found == nullptr ? "" : reinterpret_cast<const char*>(found);
}

std::string Context::version() const {
    requireCurrent("version");
    return text(GL_VERSION);
}

std::string Context::renderer() const {
    requireCurrent("renderer");
    return text(GL_RENDERER);
}

std::string Context::errors() const {
    requireCurrent("errors");
    const auto getError = entry<PFNGLGETERRORPROC>(*this, "glGetError");
    std::string names;
    // A lost context may report errors without end; no context can hold more than a few.
    for (int count = 0; count < 16; ++count) {
        const GLenum error = getError();
        if (error == GL_NO_ERROR) {
            break;
        }
        names += (names.empty() ? "" : ", ") + errorName(error);
    }
    return names;
}

Pixels Context::readPixels() const {
    requireCurrent("readPixels");
    Pixels pixels{width_, height_, {}};
    pixels.rgba.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);

    entry<PFNGLFINISHPROC>(*this, "glFinish")();
    errors();
    entry<PFNGLBINDFRAMEBUFFERPROC>(*this, "glBindFramebuffer")(GL_READ_FRAMEBUFFER, framebuffer());
    entry<PFNGLBINDBUFFERPROC>(*this, "glBindBuffer")(GL_PIXEL_PACK_BUFFER, 0);
    const auto pixelStore = entry<PFNGLPIXELSTOREIPROC>(*this, "glPixelStorei");
    pixelStore(GL_PACK_ALIGNMENT, 1);
    for (GLenum unused : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS}) {
        pixelStore(unused, 0);
    }
    entry<PFNGLREADPIXELSPROC>(*this, "glReadPixels")(0, 0, width_, height_, GL_RGBA,
                                                      GL_UNSIGNED_BYTE, pixels.rgba.data());
    if (const std::string found = errors(); !found.empty()) {
        throw Error("reading the picture failed: " + found);
    }
    flipRows(pixels);
    return pixels;
}

}  // namespace cg
