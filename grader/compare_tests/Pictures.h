#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "compare/Picture.h"

/// Pictures that the scoring rule is tried on: small scenes drawn here, and what may happen to
/// them.
namespace trial {

using grader::Picture;
using grader::Rgb;

/// A shaded disc, or a plain box where `shaded` is false.
struct Thing {
    double x, y, radius;
    Rgb colour;
    bool shaded = true;
};

struct Scene {
    std::string name;
    Rgb clear;
    std::vector<Thing> things;  ///< the first is the one that is moved, left out or painted wrongly
};

std::vector<Scene> scenes();

Picture draw(const Scene& scene);

/// The scene as an untouched starter draws it: all things at another place.
Picture starterOf(const Scene& scene);
Picture without(Scene scene);
Picture moved(Scene scene, double pixels);
Picture painted(Scene scene);

Picture noisy(Picture picture, int most, unsigned seed);
Picture shifted(const Picture& picture, int pixels);
/// Interpolated over the other diagonal: colours differ by up to 2/255 here and there.
Picture otherDiagonal(Picture picture);
Picture blurred(const Picture& picture, int radius);
Picture withPower(Picture picture, double exponent);
Picture flippedRows(const Picture& picture);
Picture swappedChannels(Picture picture);

}  // namespace trial
