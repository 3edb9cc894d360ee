#include <cg/Error.h>
#include <cg/image.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>

namespace cg {
namespace {

constexpr std::size_t maxPixels = std::size_t(1) << 26;  // a few bytes can claim more than memory

std::size_t rgbaBytes(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
}

void requireSize(const std::string& path, int width, int height) {
    if (width < 1 || height < 1 || width > maxSide || height > maxSide) {
        throw Error(path + ": a picture has 1 to " + std::to_string(maxSide) +
                    " pixels a side, this one has " + std::to_string(width) + " x " +
                    std::to_string(height));
    }
    if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > maxPixels) {
        throw Error(path + ": a picture has at most " + std::to_string(maxPixels) +
                    " pixels, this one has " + std::to_string(width) + " x " +
                    std::to_string(height));
    }
}

/// Of anything else, OpenImageIO hands over more than width x height pixels.
void requireFlat(const std::string& path, const OIIO::ImageSpec& spec) {
    if (spec.depth > 1 || spec.deep) {
        const std::string found = spec.deep
                                      ? "has several values a pixel"
                                      : "is a volume of " + std::to_string(spec.depth) + " layers";
        throw Error(path + ": the picture " + found + "; save it flat, as .png");
    }
}

/// Spreads 1 (grey), 2 (grey, alpha), 3 or 4 channels over RGBA.
Pixels toRgba(const std::vector<std::uint8_t>& values, int width, int height, int channels) {
    Pixels pixels{width, height, std::vector<std::uint8_t>(rgbaBytes(width, height)), {}};
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

/// A linear value in sRGB (IEC 61966-2-1), 0 to 255.
std::uint8_t toSrgb(float linear) {
    const float v = std::clamp(linear, 0.0f, 1.0f);
    const float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
    return static_cast<std::uint8_t>(std::lround(255.0f * encoded));
}

/// Reads floats; `broken` gets a 1 for each pixel with a value that is no number.
std::vector<std::uint8_t> readFloats(OIIO::ImageInput& input, int channels,
                                     std::vector<std::uint8_t>& broken) {
    const auto pixels = rgbaBytes(input.spec().width, input.spec().height) / 4;
    std::vector<float> floats(pixels * static_cast<std::size_t>(channels));
    if (!input.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, floats.data()))
        return {};
    std::vector<std::uint8_t> values(floats.size());
    for (std::size_t i = 0; i < floats.size(); ++i) {
        const bool isAlpha =
            channels % 2 == 0 && i % std::size_t(channels) + 1 == std::size_t(channels);
        if (!std::isfinite(floats[i])) {
            broken.resize(pixels, 0);
            broken[i / static_cast<std::size_t>(channels)] = 1;
        } else {
            values[i] = isAlpha ? static_cast<std::uint8_t>(
                                      std::lround(255.0f * std::clamp(floats[i], 0.0f, 1.0f)))
                                : toSrgb(floats[i]);
        }
    }
    return values;
}

/// For a caller in C, who frees it.
unsigned char* copyOf(const std::vector<std::uint8_t>& bytes) {
    auto* copy = static_cast<unsigned char*>(std::malloc(bytes.size()));
    if (copy == nullptr) {
        throw std::bad_alloc();
    }
    std::memcpy(copy, bytes.data(), bytes.size());
    return copy;
}

int report(const std::exception& failure, char* error, std::size_t errorSize) {
    if (error != nullptr && errorSize > 0) {
        std::snprintf(error, errorSize, "%s", failure.what());
    }
    return 1;
}

}  // namespace

Pixels readImage(const std::string& path) {
    std::error_code failure;
    if (!std::filesystem::exists(path, failure)) {
        throw Error(path + ": " + (failure ? failure.message() : "no such file"));
    }
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    // What a picture claims to hold is not to be believed before it is known to be no more than
    // this.
    OIIO::attribute("limits:imagesize_MB", static_cast<int>(maxPixels * 4 * sizeof(float) >> 20));
    const auto input = OIIO::ImageInput::open(path, &wish);
    if (!input) {
        throw Error(path + ": not a picture that can be read (" + OIIO::geterror() + ")");
    }
    const OIIO::ImageSpec& spec = input->spec();
    requireSize(path, spec.width, spec.height);
    requireFlat(path, spec);
    const int channels = std::min(spec.nchannels, 4);
    std::vector<std::uint8_t> values, broken;
    if (spec.format.is_floating_point()) {
        values = readFloats(*input, channels, broken);
    } else {
        values.resize(rgbaBytes(spec.width, spec.height) / 4 * static_cast<std::size_t>(channels));
        if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, values.data()))
            values.clear();
    }
    if (values.empty()) {
        throw Error(path + ": the picture is damaged (" + input->geterror() + ")");
    }
    Pixels pixels = toRgba(values, spec.width, spec.height, channels);
    pixels.broken = std::move(broken);
    return pixels;
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

int cg_image_read(const char* path, int* width, int* height, unsigned char** rgba,
                  unsigned char** broken, char* error, std::size_t errorSize) {
    *rgba = *broken = nullptr;
    try {
        const cg::Pixels pixels = cg::readImage(path);
        *rgba = cg::copyOf(pixels.rgba);
        *broken = pixels.broken.empty() ? nullptr : cg::copyOf(pixels.broken);
        *width = pixels.width;
        *height = pixels.height;
        return 0;
    } catch (const std::exception& failure) {
        std::free(*rgba);
        *rgba = nullptr;
        return cg::report(failure, error, errorSize);
    }
}

int cg_image_write(const char* path, int width, int height, const unsigned char* rgba, char* error,
                   std::size_t errorSize) {
    try {
        cg::requireSize(path, width, height);
        cg::writeImage(path, {width, height, {rgba, rgba + cg::rgbaBytes(width, height)}, {}});
        return 0;
    } catch (const std::exception& failure) {
        return cg::report(failure, error, errorSize);
    }
}
