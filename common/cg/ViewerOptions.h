#pragma once

#include <string>

namespace cg {

/// What a window's command line can say.
struct ViewerOptions {
    int width = 800;         ///< of the window, in screen units, 1 to 16384 (--size WxH)
    int height = 600;        ///< likewise
    std::string screenshot;  ///< write the first picture here and quit; empty: no (--screenshot)
    bool help = false;       ///< print the usage and quit (--help)
};

/// Reads the command line. Throws cg::Error that names the argument and what is allowed.
ViewerOptions parseViewerOptions(int argc, const char* const* argv);

/// The text for --help.
std::string viewerUsage(const std::string& program);

}  // namespace cg
