#pragma once

#include <cg/Context.h>

#include <array>
#include <cstddef>

#include "protocol/Bytes.h"

namespace runner {

/// A colour that no scene of the course has: what a frame leaves of it was neither cleared nor
/// drawn, and would show whatever was in memory.
using Filling = std::array<std::uint8_t, 4>;  // red, green, blue, alpha
inline constexpr Filling kFirstFilling = {113, 7, 201, 93}, kSecondFilling = {9, 203, 17, 171};

/// Fills the whole framebuffer, whatever an earlier frame left of scissors and masks.
void fill(const cg::Context& context, const Filling& colour);

/// Whether any pixel of an RGBA picture has that colour.
bool shows(const protocol::Bytes& rgba, const Filling& colour);

/// Pixels that show the first filling in one picture and the second in the other, both of one size.
std::size_t undrawnPixels(const protocol::Bytes& overFirst, const protocol::Bytes& overSecond);

}  // namespace runner
