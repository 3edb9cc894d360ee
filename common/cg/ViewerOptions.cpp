#include <cg/Error.h>
#include <cg/Pixels.h>
#include <cg/ViewerOptions.h>

#include <regex>

namespace cg {
namespace {

void parseSize(const std::string& text, ViewerOptions& options) {
    static const std::regex pattern(R"((\d{1,5})x(\d{1,5}))");
    std::smatch found;
    if (std::regex_match(text, found, pattern)) {
        options.width = std::stoi(found.str(1));
        options.height = std::stoi(found.str(2));
        if (options.width >= 1 && options.height >= 1 && options.width <= maxSide &&
            options.height <= maxSide) {
            return;
        }
    }
    throw Error("--size " + text + ": expected WIDTHxHEIGHT such as 800x600, each 1 to " +
                std::to_string(maxSide));
}

}  // namespace

ViewerOptions parseViewerOptions(int argc, const char* const* argv, const ViewerOptions& defaults) {
    ViewerOptions options = defaults;
    for (int k = 1; k < argc; ++k) {
        const std::string argument = argv[k];
        const auto value = [&]() -> std::string {
            if (++k >= argc) {
                throw Error(argument + ": a value is missing; see --help");
            }
            return argv[k];
        };
        if (argument == "--size") {
            parseSize(value(), options);
        } else if (argument == "--screenshot") {
            options.screenshot = value();
        } else if (argument == "--help" || argument == "-h") {
            options.help = true;
        } else {
            throw Error(argument + ": unknown option; see --help");
        }
    }
    return options;
}

std::string viewerUsage(const std::string& program, const ViewerOptions& defaults) {
    return "Usage: " + program +
           " [--size WIDTHxHEIGHT] [--screenshot FILE]\n"
           "  --size WIDTHxHEIGHT  size of the window, " +
           std::to_string(defaults.width) + "x" + std::to_string(defaults.height) +
           " unless told otherwise\n"
           "  --screenshot FILE    write the first picture to FILE (PNG) and quit\n"
           "  --help               print this and quit\n";
}

}  // namespace cg
