#pragma once

#include <string>

namespace cg {

/// What a window's command line can say.
struct ViewerOptions {
    int width = 800;         ///< of the window, in screen units, 1 to maxSide (--size WxH)
    int height = 600;        ///< likewise
    std::string screenshot;  ///< write the first picture here and quit; empty: no (--screenshot)
    bool help = false;       ///< print the usage and quit (--help)
};

/// Reads the command line; what it does not say is taken from `defaults`. Throws cg::Error that
/// names the argument and what is allowed.
ViewerOptions parseViewerOptions(int argc, const char* const* argv,
                                 const ViewerOptions& defaults = {});

/// The text for --help.
std::string viewerUsage(const std::string& program, const ViewerOptions& defaults = {});

}  // namespace cg
