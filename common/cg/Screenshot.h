#pragma once

#include <cg/Pixels.h>

#include <string>

namespace cg {

/// Writes the picture to the current folder as STEM.png, or as STEM-2.png, STEM-3.png ... when
/// those before are taken; no file is ever overwritten. Returns the name. Throws cg::Error.
std::string saveScreenshot(const std::string& stem, const Pixels& pixels);

}  // namespace cg
