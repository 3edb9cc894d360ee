#pragma once

#include <cg/Context.h>

#include <memory>
#include <string>

namespace cg {

/// A context that draws into memory on the CPU, without a screen: OpenGL 3.3 core (or later),
/// RGBA8, 24 bits of depth. It is current when returned. `provider`:
///     "osmesa"  libOSMesa, which Mesa has up to version 25.0
///     "egl"     EGL on Mesa's surfaceless platform
///     "auto"    the first of these that this machine has
/// Libraries are opened at run time, with their symbols visible to code loaded afterwards; a
/// process uses one provider. Both draw into a framebuffer object, which stays bound, and draw the
/// same picture to the last bit.
/// Throws cg::Error: no library found (names those tried), no such context, unknown provider.
std::unique_ptr<Context> createHeadlessContext(const std::string& provider, int width, int height);

}  // namespace cg
