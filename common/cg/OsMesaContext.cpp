#include <cg/Error.h>
#include <cg/FramebufferObject.h>
#include <cg/OsMesaContext.h>
#include <cg/SoftwareDriver.h>

#include <dlfcn.h>

#include <cstdint>
#include <vector>

namespace cg {
namespace {

// What this file needs of <GL/osmesa.h>, so that building takes no package beyond the run-time one.
struct OsMesaHandle;
constexpr int FORMAT = 0x22, DEPTH_BITS = 0x30, STENCIL_BITS = 0x31, ACCUM_BITS = 0x32;
constexpr int PROFILE = 0x33, CORE_PROFILE = 0x34, MAJOR_VERSION = 0x36, MINOR_VERSION = 0x37;
constexpr int RGBA = 0x1908;
constexpr unsigned UNSIGNED_BYTE = 0x1401;

struct Library {
    OsMesaHandle* (*create)(const int* attributes, OsMesaHandle* sharedWith);
    void (*destroy)(OsMesaHandle* context);
    unsigned char (*makeCurrent)(OsMesaHandle* context, void* buffer, unsigned type, int width,
                                 int height);
    void* (*function)(const char* name);
};

void* openLibrary() {
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        if (void* handle = dlopen(name, RTLD_NOW | RTLD_GLOBAL)) {
            return handle;
        }
    }
    throw Error(
        "no OSMesa library found (tried libOSMesa.so.8, libOSMesa.so.6, libOSMesa.so): "
        "install libosmesa6");
}

template <class Function>
void load(void* handle, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(handle, name));
    if (function == nullptr) {
        throw Error(std::string("this OSMesa library has no ") + name +
                    ": install libosmesa6 of Mesa 13 or later");
    }
}

Library loadLibrary() {
    chooseSoftwareDriver();
    void* handle = openLibrary();
    Library library{};
    load(handle, "OSMesaCreateContextAttribs", library.create);
    load(handle, "OSMesaDestroyContext", library.destroy);
    load(handle, "OSMesaMakeCurrent", library.makeCurrent);
    load(handle, "OSMesaGetProcAddress", library.function);
    return library;
}

/// The library stays open until the process ends: code loaded later is bound to its symbols.
const Library& osMesa() {
    static const Library library = loadLibrary();
    return library;
}

class OsMesaContext : public Context {
public:
    OsMesaContext(int width, int height) : Context(width, height) {
        const int attributes[] = {FORMAT,        RGBA, DEPTH_BITS, 24,           STENCIL_BITS,  8,
                                  ACCUM_BITS,    0,    PROFILE,    CORE_PROFILE, MAJOR_VERSION, 3,
                                  MINOR_VERSION, 3,    0};
        handle_ = osMesa().create(attributes, nullptr);
        if (handle_ == nullptr) {
            throw Error("OSMesa could not make an OpenGL 3.3 core context");
        }
        fitBuffer();
    }

    ~OsMesaContext() override {
        if (isCurrent()) {
            osMesa().makeCurrent(nullptr, nullptr, 0, 0, 0);
        }
        osMesa().destroy(handle_);
    }

    const char* provider() const override { return "osmesa"; }

    void makeCurrent() override {
        if (osMesa().makeCurrent(handle_, buffer_.data(), UNSIGNED_BYTE, width(), height()) == 0) {
            throw Error("OSMesa refuses a framebuffer of " + std::to_string(width()) + " x " +
                        std::to_string(height()) + " pixels");
        }
        becomeCurrent();
        if (picture_.name() == 0) {
            picture_.make();
        }
    }

    void resizeFramebuffer(int newWidth, int newHeight) override {
        resize(newWidth, newHeight);
        fitBuffer();
        makeCurrent();
        picture_.make();
    }

    void* function(const char* name) const override { return osMesa().function(name); }

protected:
    unsigned framebuffer() const override { return picture_.name(); }

private:
    void fitBuffer() {
        buffer_.resize(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) * 4);
    }

    OsMesaHandle* handle_;
    std::vector<std::uint8_t> buffer_;  ///< OSMesa asks for one; the picture is drawn elsewhere
    FramebufferObject picture_{*this};
};

}  // namespace

std::unique_ptr<Context> createOsMesaContext(int width, int height) {
    auto context = std::make_unique<OsMesaContext>(width, height);
    context->makeCurrent();
    return context;
}

}  // namespace cg
