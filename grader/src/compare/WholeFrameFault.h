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
    Picture mended;    ///< the frame with it undone
};

/// Share of a frame's points that a whole-frame fault costs, once.
inline constexpr double kFaultCharge = 0.5;

/// The fault without which the frame is the reference: at most `kStrayPixels` of the pixels are
/// still outliers. Nothing when there is none, or more than one at a time.
std::optional<WholeFrameFault> findWholeFrameFault(const Picture& frame, const Picture& reference);

inline constexpr double kStrayPixels = 0.01;

}  // namespace grader
