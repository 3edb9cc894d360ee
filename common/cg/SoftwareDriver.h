#pragma once

#include <cstdlib>
#include <string>

namespace cg {

/// Makes Mesa draw on the CPU, in every context made afterwards: pictures must not depend on a
/// graphics card. GALLIUM_DRIVER may ask for softpipe, Mesa's plain rasteriser, which proves that
/// no mark hangs on one driver; whatever else it says, llvmpipe draws.
inline void chooseSoftwareDriver() {
    const char* asked = std::getenv("GALLIUM_DRIVER");
    if (asked == nullptr || std::string(asked) != "softpipe")
        setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
}

}  // namespace cg
