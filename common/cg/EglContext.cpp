#include <cg/EglContext.h>
#include <cg/Error.h>
#include <cg/FramebufferObject.h>
#include <cg/SoftwareDriver.h>

#include <dlfcn.h>

#include <cstdint>
#include <string>

namespace cg {
namespace {

// What this file needs of <EGL/egl.h>, so that building takes no package beyond the run-time one.
using Handle = void*;
constexpr unsigned PLATFORM_SURFACELESS_MESA = 0x31DD, OPENGL_API = 0x30A2;
constexpr std::int32_t NONE = 0x3038, MAJOR_VERSION = 0x3098, MINOR_VERSION = 0x30FB;
constexpr std::int32_t PROFILE_MASK = 0x30FD, CORE_PROFILE_BIT = 1;

struct Library {
    void* openGl;
    void* (*function)(const char* name);
    Handle (*getPlatformDisplay)(unsigned platform, Handle native, const std::int32_t* attributes);
    unsigned (*initialize)(Handle display, std::int32_t* major, std::int32_t* minor);
    unsigned (*bindApi)(unsigned api);
    Handle (*createContext)(Handle display, Handle config, Handle shared,
                            const std::int32_t* attributes);
    unsigned (*makeCurrent)(Handle display, Handle draw, Handle read, Handle context);
    unsigned (*destroyContext)(Handle display, Handle context);
};

void* openLibrary(const char* name) {
    void* handle = dlopen(name, RTLD_NOW | RTLD_GLOBAL);
    if (handle == nullptr) {
        throw Error(std::string("no EGL to be had (tried ") + name +
                    "): install libegl1 and libopengl0");
    }
    return handle;
}

template <class Function>
void load(void* address, const char* name, Function& function) {
    function = reinterpret_cast<Function>(address);
    if (function == nullptr) {
        throw Error(std::string("this EGL has no ") + name + ": install libegl-mesa0");
    }
}

Library loadLibrary() {
    chooseSoftwareDriver();
    Library library{};
    library.openGl = openLibrary("libOpenGL.so.0");
    void* egl = openLibrary("libEGL.so.1");
    load(dlsym(egl, "eglGetProcAddress"), "eglGetProcAddress", library.function);
    load(library.function("eglGetPlatformDisplayEXT"), "eglGetPlatformDisplayEXT",
         library.getPlatformDisplay);
    load(dlsym(egl, "eglInitialize"), "eglInitialize", library.initialize);
    load(dlsym(egl, "eglBindAPI"), "eglBindAPI", library.bindApi);
    load(dlsym(egl, "eglCreateContext"), "eglCreateContext", library.createContext);
    load(dlsym(egl, "eglMakeCurrent"), "eglMakeCurrent", library.makeCurrent);
    load(dlsym(egl, "eglDestroyContext"), "eglDestroyContext", library.destroyContext);
    return library;
}

const Library& egl() {
    static const Library library = loadLibrary();
    return library;
}

/// One display for all contexts of a process; it stays open until the process ends.
Handle display() {
    static const Handle opened = [] {
        const Handle handle = egl().getPlatformDisplay(PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (handle == nullptr || egl().initialize(handle, nullptr, nullptr) == 0) {
            throw Error("EGL has no surfaceless display: install libegl-mesa0");
        }
        return handle;
    }();
    return opened;
}

class EglContext : public Context {
public:
    EglContext(int width, int height) : Context(width, height) {
        egl().bindApi(OPENGL_API);
        const std::int32_t attributes[] = {MAJOR_VERSION,    3,   MINOR_VERSION, 3, PROFILE_MASK,
                                           CORE_PROFILE_BIT, NONE};
        handle_ = egl().createContext(display(), nullptr, nullptr, attributes);
        if (handle_ == nullptr) {
            throw Error("EGL could not make an OpenGL 3.3 core context");
        }
    }

    ~EglContext() override {
        if (isCurrent()) {
            egl().makeCurrent(display(), nullptr, nullptr, nullptr);
        }
        egl().destroyContext(display(), handle_);
    }

    const char* provider() const override { return "egl"; }

    void makeCurrent() override {
        if (egl().makeCurrent(display(), nullptr, nullptr, handle_) == 0) {
            throw Error("EGL refuses to make its context current");
        }
        becomeCurrent();
        if (picture_.name() == 0) {
            picture_.make();
        }
    }

    void resizeFramebuffer(int newWidth, int newHeight) override {
        resize(newWidth, newHeight);
        makeCurrent();
        picture_.make();
    }

    void* function(const char* name) const override {
        void* address = dlsym(egl().openGl, name);
        return address != nullptr ? address : egl().function(name);
    }

protected:
    unsigned framebuffer() const override { return picture_.name(); }

private:
    Handle handle_ = nullptr;
    FramebufferObject picture_{*this};
};

}  // namespace

std::unique_ptr<Context> createEglContext(int width, int height) {
    auto context = std::make_unique<EglContext>(width, height);
    context->makeCurrent();
    return context;
}

}  // namespace cg
