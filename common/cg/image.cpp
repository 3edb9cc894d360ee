#include <cg/Error.h>
#include <cg/image.h>

#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace cg {
namespace {

constexpr int maxSide = 16384;

std::size_t rgbaBytes(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
}

void requireSize(const std::string& path, int width, int height) {
    if (width < 1 || height < 1 || width > maxSide || height > maxSide) {
        throw Error(path + ": a picture has 1 to " + std::to_string(maxSide) +
                    " pixels a side, this one has " + std::to_string(width) + " x " +
                    std::to_string(height));
    }
}

/// Spreads 1 (grey), 2 (grey, alpha), 3 or 4 channels over RGBA.
Pixels toRgba(const std::vector<std::uint8_t>& values, int width, int height, int channels) {
    Pixels pixels{width, height, std::vector<std::uint8_t>(rgbaBytes(width, height))};
    const bool grey = channels < 3;
    const bool hasAlpha = channels == 2 || channels == 4;
    const std::uint8_t* from = values.data();
    for (std::size_t to = 0; to < pixels.rgba.size(); to += 4, from += channels) {
        pixels.rgba[to] = from[0];
        pixels.rgba[to + 1] = from[grey ? 0 : 1];
        pixels.rgba[to + 2] = from[grey ? 0 : 2];
        pixels.rgba[to + 3] = hasAlpha ? from[channels - 1] : 255;
    }
    return pixels;
}

int report(const std::exception& failure, char* error, std::size_t errorSize) {
    if (error != nullptr && errorSize > 0) {
        std::snprintf(error, errorSize, "%s", failure.what());
    }
    return 1;
}

}  // namespace

Pixels readImage(const std::string& path) {
    if (!std::filesystem::exists(path)) {
        throw Error(path + ": no such file");
    }
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path, &wish);
    if (!input) {
        throw Error(path + ": not a picture that can be read (" + OIIO::geterror() + ")");
    }
    const OIIO::ImageSpec& spec = input->spec();
    requireSize(path, spec.width, spec.height);
    const int channels = std::min(spec.nchannels, 4);
    std::vector<std::uint8_t> values(rgbaBytes(spec.width, spec.height) / 4 *
                                     static_cast<std::size_t>(channels));
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, values.data())) {
        throw Error(path + ": the picture is damaged (" + input->geterror() + ")");
    }
    return toRgba(values, spec.width, spec.height, channels);
}

void writeImage(const std::string& path, const Pixels& pixels) {
    requireSize(path, pixels.width, pixels.height);
    if (pixels.rgba.size() != rgbaBytes(pixels.width, pixels.height)) {
        throw Error(path + ": a picture of " + std::to_string(pixels.width) + " x " +
                    std::to_string(pixels.height) + " pixels needs 4 bytes each, found " +
                    std::to_string(pixels.rgba.size()));
    }
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) {
        throw Error(path + ": no picture format has this ending, use .png (" + OIIO::geterror() +
                    ")");
    }
    const OIIO::ImageSpec spec(pixels.width, pixels.height, 3, OIIO::TypeDesc::UINT8);
    // A stride of four bytes steps over the alpha.
    if (!output->open(path, spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, pixels.rgba.data(), 4) || !output->close()) {
        throw Error(path + ": cannot be written (" + output->geterror() + ")");
    }
}

}  // namespace cg

int cg_image_read(const char* path, int* width, int* height, unsigned char** rgba, char* error,
                  std::size_t errorSize) {
    *rgba = nullptr;
    try {
        const cg::Pixels pixels = cg::readImage(path);
        auto* copy = static_cast<unsigned char*>(std::malloc(pixels.rgba.size()));
        if (copy == nullptr) {
            throw cg::Error(std::string(path) + ": not enough memory");
        }
        std::memcpy(copy, pixels.rgba.data(), pixels.rgba.size());
        *width = pixels.width;
        *height = pixels.height;
        *rgba = copy;
        return 0;
    } catch (const std::exception& failure) {
        return cg::report(failure, error, errorSize);
    }
}

int cg_image_write(const char* path, int width, int height, const unsigned char* rgba, char* error,
                   std::size_t errorSize) {
    try {
        cg::requireSize(path, width, height);
        cg::writeImage(path, {width, height, {rgba, rgba + cg::rgbaBytes(width, height)}});
        return 0;
    } catch (const std::exception& failure) {
        return cg::report(failure, error, errorSize);
    }
}
