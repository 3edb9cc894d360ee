#pragma once

#include "compare/Planes.h"

namespace grader {

/// The boundaries of what a picture shows.
struct Boundaries {
    Map edges;  ///< 1 where a pixel differs much from its right or lower neighbour
    Map near;   ///< 1 within two pixels of such a place
    double count = 0;
    double sharpness = 1;  ///< of those places with much contrast around them, how sharp they are
};

Boundaries boundariesOf(const Planes& planes);

/// F1 score: harmonic mean of the share of the frame's boundaries that the reference has within two
/// pixels, and of the reference's that the frame has. 0 … 1; 1 when neither has any.
double boundaryMatch(const Boundaries& frame, const Boundaries& reference);

}  // namespace grader
