#include "compare_tests/Pictures.h"

#include <algorithm>
#include <random>

namespace trial {

namespace {

constexpr int kWidth = 800, kHeight = 600;

std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

/// The colour of a thing at (x, y), lit from the top left; nothing where it is not.
bool paint(const Thing& thing, int x, int y, std::uint8_t* pixel) {
    const double dx = (x + 0.5 - thing.x) / thing.radius, dy = (y + 0.5 - thing.y) / thing.radius;
    if (thing.shaded ? dx * dx + dy * dy > 1 : std::max(std::abs(dx), std::abs(dy)) > 1)
        return false;
    const double dz = thing.shaded ? std::sqrt(std::max(0.0, 1 - dx * dx - dy * dy)) : 0.0;
    const double diffuse = thing.shaded ? std::max(0.0, -0.5 * dx - 0.5 * dy + 0.7 * dz) : 0.8;
    const double highlight = thing.shaded ? 120 * std::pow(diffuse, 30) : 0;
    for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = byte(thing.colour[c] * (0.2 + 0.8 * diffuse) + highlight);
    return true;
}

}  // namespace

std::vector<Scene> scenes() {
    return {{"discs",
             {0, 0, 0},
             {{220, 210, 70, {230, 80, 60}},
              {520, 200, 90, {70, 200, 90}},
              {430, 440, 110, {80, 110, 230}}}},
            {"boxes",
             {90, 100, 110},
             {{200, 220, 60, {240, 200, 40}, false},
              {560, 170, 80, {40, 60, 160}, false},
              {520, 430, 100, {200, 60, 90}}}},
            {"bright",
             {235, 235, 230},
             {{240, 200, 80, {90, 140, 220}}, {540, 330, 140, {160, 60, 30}, false}}}};
}

Picture draw(const Scene& scene) {
    Picture picture{kWidth, kHeight, std::vector<std::uint8_t>(4 * kWidth * kHeight, 255), {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            std::uint8_t* pixel = picture.pixel(x, y);
            std::copy(scene.clear.begin(), scene.clear.end(), pixel);
            for (const Thing& thing : scene.things)
                paint(thing, x, y, pixel);
        }
    return picture;
}

Picture starterOf(const Scene& scene) {
    Scene blank = scene;
    for (Thing& thing : blank.things) {
        thing.x = kWidth / 2.0;
        thing.y = kHeight / 2.0;
        thing.radius *= 0.6;
    }
    return draw(blank);
}

Picture without(Scene scene) {
    scene.things.erase(scene.things.begin());
    return draw(scene);
}

Picture moved(Scene scene, double pixels) {
    scene.things.front().x += pixels;
    return draw(scene);
}

Picture painted(Scene scene) {
    std::swap(scene.things.front().colour[0], scene.things.front().colour[2]);
    return draw(scene);
}

Picture noisy(Picture picture, int most, unsigned seed) {
    std::mt19937 engine(seed);
    const auto values = static_cast<unsigned>(2 * most + 1);
    for (std::uint8_t& each : picture.rgba)
        each = byte(each + static_cast<int>(engine() % values) - most);
    return picture;
}

Picture shifted(const Picture& picture, int pixels) {
    Picture result = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            std::copy_n(picture.pixel(std::clamp(x - pixels, 0, picture.width - 1), y), 4,
                        result.pixel(x, y));
    return result;
}

Picture otherDiagonal(Picture picture) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c)
                picture.pixel(x, y)[c] =
                    byte(picture.pixel(x, y)[c] + 2 * std::sin(0.05 * x) * std::sin(0.07 * y));
    return picture;
}

Picture blurred(const Picture& picture, int radius) {
    Picture along = picture, result = picture;
    const auto average = [radius](const Picture& from, Picture& to, int dx, int dy) {
        for (int y = 0; y < from.height; ++y)
            for (int x = 0; x < from.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    int sum = 0;
                    for (int k = -radius; k <= radius; ++k)
                        sum += from.pixel(std::clamp(x + k * dx, 0, from.width - 1),
                                          std::clamp(y + k * dy, 0, from.height - 1))[c];
                    to.pixel(x, y)[c] = byte(sum / (2.0 * radius + 1));
                }
    };
    average(picture, along, 1, 0);
    average(along, result, 0, 1);
    return result;
}

Picture withPower(Picture picture, double exponent) {
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3)
            picture.rgba[i] = byte(255 * std::pow(picture.rgba[i] / 255.0, exponent));
    return picture;
}

Picture flippedRows(const Picture& picture) {
    Picture result = picture;
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.pixel(0, picture.height - 1 - y), 4 * picture.width,
                    result.pixel(0, y));
    return result;
}

Picture swappedChannels(Picture picture) {
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        std::swap(picture.rgba[i], picture.rgba[i + 2]);
    return picture;
}

}  // namespace trial
