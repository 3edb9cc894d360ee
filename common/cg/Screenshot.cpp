#include <cg/Error.h>
#include <cg/Screenshot.h>
#include <cg/image.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace cg {
namespace {

/// Makes an empty file of this name; false when there is one already.
bool reserve(const std::string& name) {
    if (std::FILE* file = std::fopen(name.c_str(), "wx")) {
        std::fclose(file);
        return true;
    }
    if (errno != EEXIST) {
        throw Error(name + ": the screenshot cannot be written (" + std::strerror(errno) + ")");
    }
    return false;
}

}  // namespace

std::string saveScreenshot(const std::string& stem, const Pixels& pixels) {
    std::string name = stem + ".png";
    for (int number = 2; !reserve(name); ++number) {
        name = stem + "-" + std::to_string(number) + ".png";
    }
    try {
        writeImage(name, pixels);
    } catch (const Error&) {
        std::remove(name.c_str());
        throw;
    }
    return name;
}

}  // namespace cg
