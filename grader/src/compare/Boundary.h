#pragma once

#include "compare/Planes.h"

namespace grader {

/// The boundaries of what a picture shows.
struct Boundaries {
    Map edges;         ///< at half size: how clearly a pixel differs from its neighbours, 0 … 255
    Map near;          ///< the clearest within two pixels of the picture
    double count = 0;  ///< sum of edges
    double sharpness = 1;  ///< where there is contrast: 1 / width of its boundaries, about
};

Boundaries boundariesOf(const Planes& planes);

/// F1 score: harmonic mean of the share of the frame's boundaries that the reference has within two
/// pixels, and of the reference's that the frame has. 0 … 1; 1 when neither has any.
double boundaryMatch(const Boundaries& frame, const Boundaries& reference);

}  // namespace grader
