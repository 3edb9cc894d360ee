// A picture that somebody hands to `grader compare`. The first byte chooses the file's ending, and
// every reader of OpenImageIO may try, as there. OpenImageIO itself is not instrumented, so
// mutation goes blind in it; what it hands over is checked.

#include <unistd.h>

#include <OpenImageIO/imageio.h>
#include <cg/Error.h>
#include <cg/image.h>

#include <fstream>

#include "Fuzz.h"

namespace {

/// OpenImageIO 2.4 never comes back from a flat DDS with an empty mask (its issue 3993), and the
/// fuzzer would find nothing else.
bool isFlatDds(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    return input && input->format_name() == std::string("dds") && input->spec().depth <= 1;
}

void read(const std::string& path) {
    try {
        const cg::Pixels pixels = cg::readImage(path);
        fuzz::require(pixels.width > 0 && pixels.height > 0, "a picture has a size");
        fuzz::require(pixels.width <= cg::maxSide && pixels.height <= cg::maxSide,
                      "and not too large a one");
        fuzz::require(pixels.rgba.size() <= std::size_t(4) << 26, "nor too many pixels");
        fuzz::require(pixels.rgba.size() ==
                          std::size_t(4) * std::size_t(pixels.width) * std::size_t(pixels.height),
                      "and all of its pixels");
    } catch (const cg::Error&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const char* const kEndings[] = {".png", ".exr", ".hdr", ".ppm"};
    if (size == 0)
        return 0;
    const std::string path = "/dev/shm/fuzz-" + std::to_string(getpid()) + kEndings[data[0] % 4];
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data + 1), std::streamsize(size - 1));
    if (!isFlatDds(path))
        read(path);
    unlink(path.c_str());
    return 0;
}
