#pragma once

#include "compare/Planes.h"

namespace grader {

/// What correct drivers differ by, and from where on a pixel is as wrong as can be; of 255.
inline constexpr int kDeadZone = 4;
inline constexpr int kSaturated = 64;

/// Largest channel difference of each pixel, the least over its 3x3 neighbourhood in the other
/// picture, taken in both directions and the larger kept: an edge that moved by a pixel is no
/// difference. Both pictures have one size.
Map tolerantDifference(const Planes& a, const Planes& b);

/// Largest channel difference of each pixel.
Map plainDifference(const Planes& a, const Planes& b);

/// Error of a difference: 0 up to kDeadZone, 1 from kSaturated.
float errorOf(std::uint8_t difference);

/// Sums over a map of differences.
struct ErrorSum {
    double error = 0;     ///< of all pixels
    double outliers = 0;  ///< pixels with an error above 0
    double x = 0, y = 0;  ///< error times place: its centre, divided by `error`
};
ErrorSum sumErrors(const Map& differences, int width);

/// Sum of errors where `mask` is not 0.
double sumErrors(const Map& differences, const Map& mask);

}  // namespace grader
