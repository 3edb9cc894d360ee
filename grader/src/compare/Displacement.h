#pragma once

#include <optional>
#include <string>

#include "compare/Planes.h"

namespace grader {

/// How far from its place something is drawn, in pixels: positive is right, and down.
struct Displacement {
    int x = 0, y = 0;
    double error = 1;  ///< mean error of its pixels once it is moved back, 0 … 1

    double length() const;
    /// Share of the credit that is left: exp(-length / (width / 8)), less where it matches badly.
    double credit(int pictureWidth) const;
    /// "56 px too far right and 4 px too low"
    std::string text() const;
};

/// The picture at scales 1, 4 and 16.
struct Scales {
    Planes planes[3];
    Planes soft;  ///< scale 1 softened, for the search: noise makes no place fit better
};
Scales scalesOf(Planes planes);
inline constexpr int kScales[3] = {1, 4, 16};

/// The shift at which the frame shows best what the reference has where `object` is not 0, at most
/// half the picture away, found from coarse to fine. Nothing when it does not match anywhere, or
/// matches where it belongs.
std::optional<Displacement> findDisplacement(const Scales& frame, const Scales& reference,
                                             const Map& object);

}  // namespace grader
