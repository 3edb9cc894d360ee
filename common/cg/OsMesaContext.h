#pragma once

#include <cg/Context.h>

#include <memory>

namespace cg {

/// A context that draws into memory on the CPU: OpenGL 3.3 core (or later), RGBA8, 24 bits of
/// depth, no screen needed. It is current when returned. The library is opened at run time, with
/// its symbols visible to code loaded afterwards.
/// Throws cg::Error: no library found (names those tried), or no such context.
std::unique_ptr<Context> createOsMesaContext(int width, int height);

}  // namespace cg
