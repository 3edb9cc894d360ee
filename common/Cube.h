#pragma once

#include "Geometry.h"

/// The cube of side 1 around the origin (section 7.6.5), with flat faces: 24 vertices, four per
/// face, and two triangles per face, all counter-clockwise seen from outside.
/// Attribute 0: position (3 floats); attribute 1: outward unit normal (3 floats).
class Cube : public Geometry {
public:
    using Geometry::init;
    void init() override;
};
