#pragma once

#include "Geometry.h"

/// A mesh from a Wavefront OBJ file: polygons, cut into triangles. Materials, texture coordinates,
/// lines and points are passed over.
/// Attribute 0: position (3 floats); attribute 1: normal (3 floats), as the file gives it. If a
/// corner lacks one, all normals are computed: the mean of the adjoining triangles' normals,
/// weighted by their areas, of length 1.
class Obj : public Geometry {
public:
    using Geometry::init;

    /// Reads a file, looked up by cg::findResource ("models/teapot.obj"). Throws cg::Error, which
    /// names the file, when it is missing or unreadable, is no OBJ file, or holds no polygon; the
    /// geometry is then as before.
    void init(const char* file) override;
};
