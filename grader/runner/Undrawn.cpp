#include "runner/Undrawn.h"

#include <cg/gl.h>

#include <cstring>

namespace runner {

namespace {

bool isFilling(const std::uint8_t* pixel, const Filling& colour) {
    return std::memcmp(pixel, colour.data(), colour.size()) == 0;
}

}  // namespace

void fill(const cg::Context& context, const Filling& colour) {
    const auto gl = [&]<class Function>(Function*& into, const char* name) {
        into = reinterpret_cast<Function*>(context.function(name));
    };
    PFNGLDISABLEPROC disable;
    PFNGLCOLORMASKPROC colorMask;
    PFNGLCLEARCOLORPROC clearColor;
    PFNGLCLEARPROC clear;
    gl(disable, "glDisable");
    gl(colorMask, "glColorMask");
    gl(clearColor, "glClearColor");
    gl(clear, "glClear");
    disable(GL_SCISSOR_TEST);
    colorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const auto share = [&](std::size_t channel) { return float(colour[channel]) / 255.0f; };
    clearColor(share(0), share(1), share(2), share(3));
    clear(GL_COLOR_BUFFER_BIT);
    clearColor(0.0f, 0.0f, 0.0f, 0.0f);
}

bool shows(const protocol::Bytes& rgba, const Filling& colour) {
    for (std::size_t i = 0; i + 4 <= rgba.size(); i += 4)
        if (isFilling(&rgba[i], colour))
            return true;
    return false;
}

std::size_t undrawnPixels(const protocol::Bytes& overFirst, const protocol::Bytes& overSecond) {
    std::size_t count = 0;
    for (std::size_t i = 0; i + 4 <= overFirst.size() && i + 4 <= overSecond.size(); i += 4)
        count +=
            isFilling(&overFirst[i], kFirstFilling) && isFilling(&overSecond[i], kSecondFilling);
    return count;
}

}  // namespace runner
