#pragma once

#include "Geometry.h"
#include "Material.h"

/// A geometry with a material (definition 9.1). Several models may share either. Owns neither.
struct Model {
    Geometry* geometry = nullptr;
    Material* material = nullptr;
};
