#pragma once

#include "Geometry.h"

/// The sphere of radius 1 around the origin, its poles on the y axis, as a net of triangles that
/// are counter-clockwise seen from outside. The vertices lie on the sphere. Attribute 0: position
/// (3 floats); attribute 1: outward unit normal (3 floats).
class Sphere : public Geometry {
public:
    int slices = 48;  ///< round the y axis, at least 3
    int stacks = 24;  ///< from pole to pole, at least 2

    using Geometry::init;

    /// Throws cg::Error when slices or stacks are too few.
    void init() override;
};
