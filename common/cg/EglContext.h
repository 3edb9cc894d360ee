#pragma once

#include <cg/Context.h>

#include <memory>

namespace cg {

/// A context that draws into memory on the CPU by EGL on Mesa's surfaceless platform, for systems
/// without OSMesa: OpenGL 3.3 core (or later), RGBA8, 24 bits of depth, in a framebuffer object
/// that is bound when the context is made or resized. It is current when returned. Libraries are
/// opened at run time, with their symbols visible to code loaded afterwards.
/// Throws cg::Error: no library found (names those tried), or no such context.
std::unique_ptr<Context> createEglContext(int width, int height);

}  // namespace cg
