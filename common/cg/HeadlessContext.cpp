#include <cg/EglContext.h>
#include <cg/Error.h>
#include <cg/HeadlessContext.h>
#include <cg/OsMesaContext.h>

namespace cg {

std::unique_ptr<Context> createHeadlessContext(const std::string& provider, int width, int height) {
    if (provider == "osmesa") {
        return createOsMesaContext(width, height);
    }
    if (provider == "egl") {
        return createEglContext(width, height);
    }
    if (provider != "auto") {
        throw Error("unknown context provider \"" + provider + "\": known are osmesa, egl, auto");
    }
    try {
        return createOsMesaContext(width, height);
    } catch (const Error& osmesa) {
        try {
            return createEglContext(width, height);
        } catch (const Error& egl) {
            throw Error(std::string(osmesa.what()) + "; " + egl.what());
        }
    }
}

}  // namespace cg
