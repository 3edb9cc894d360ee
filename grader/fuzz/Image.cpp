// A picture that somebody hands to `grader compare`. The first byte chooses the format. OpenImageIO
// itself is not instrumented, so mutation goes blind there; what it hands over is checked. BMP and
// TGA are left out: OpenImageIO 2.4 reserves what their headers claim, gigabytes, before anybody
// can set a limit, and the fuzzer would find nothing else.

#include <unistd.h>

#include <OpenImageIO/imageio.h>
#include <cg/Error.h>
#include <cg/image.h>

#include <fstream>

#include "Fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const char* const kEndings[] = {".png", ".exr", ".hdr", ".ppm"};
    OIIO::attribute("try_all_readers", 0);  // not those by way of another ending
    if (size == 0)
        return 0;
    const std::string path = "/dev/shm/fuzz-" + std::to_string(getpid()) + kEndings[data[0] % 4];
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data + 1), std::streamsize(size - 1));
    try {
        const cg::Pixels pixels = cg::readImage(path);
        fuzz::require(pixels.width > 0 && pixels.height > 0, "a picture has a size");
        fuzz::require(pixels.width <= 16384 && pixels.height <= 16384, "and not too large a one");
        fuzz::require(pixels.rgba.size() <= std::size_t(4) << 26, "nor too many pixels");
        fuzz::require(pixels.rgba.size() ==
                          std::size_t(4) * std::size_t(pixels.width) * std::size_t(pixels.height),
                      "and all of its pixels");
    } catch (const cg::Error&) {
    }
    unlink(path.c_str());
    return 0;
}
