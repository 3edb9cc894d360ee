#pragma once

#include "Geometry.h"

/// The torus round the y axis whose tube has its middle on the unit circle of the plane y = 0, as a
/// net of triangles that are counter-clockwise seen from outside. The vertices lie on the torus.
/// Attribute 0: position (3 floats); attribute 1: outward unit normal (3 floats).
class Torus : public Geometry {
public:
    float tube = 0.4f;  ///< radius of the tube, above 0 and below 1
    int rings = 64;     ///< round the y axis, at least 3
    int sides = 32;     ///< round the tube, at least 3

    using Geometry::init;

    /// Throws cg::Error when tube is out of range, or rings or sides are too few.
    void init() override;
};
