#pragma once

#include <optional>
#include <string>

#include "compare/Planes.h"

namespace grader {

/// One slip that spoils every pixel of a frame and nothing else: rows or columns in the wrong
/// order, channels exchanged, gamma applied once too little or once too often.
struct WholeFrameFault {
    std::string id;    ///< "rows-flipped"
    std::string says;  ///< "its rows are upside down"
};

/// Share of a frame's points that a whole-frame fault costs, once.
inline constexpr double kFaultCharge = 0.5;

/// The one fault by which the reference becomes the frame: at most `kStrayPixels` of the pixels
/// differ then, and at most a tenth of those that do without it. Nothing when there is none, or
/// more than one at a time, or when the frame is of one colour. `outliers`: the share of pixels
/// that differ without it.
std::optional<WholeFrameFault> findWholeFrameFault(const Picture& frame, const Picture& reference,
                                                   double outliers);

inline constexpr double kStrayPixels = 0.01;

}  // namespace grader
