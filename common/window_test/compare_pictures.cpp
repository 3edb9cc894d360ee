// compare_pictures FOUND EXPECTED: whether two pictures are the same but for rounding. Exits 0 when
// they have one size and at most 0.05 % of the pixels differ by more than 4 / 255 in some colour,
// 1 when not, 2 when a file cannot be read.
// compare_pictures --colours PICTURE: prints how many different colours it has.
#include <cg/image.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <set>
#include <string>

namespace {

constexpr int toleratedDifference = 4;
constexpr double toleratedShare = 0.0005;

long countOutliers(const cg::Pixels& a, const cg::Pixels& b) {
    long outliers = 0;
    for (std::size_t k = 0; k < a.rgba.size(); k += 4) {
        bool far = false;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            far |= std::abs(a.rgba[k + channel] - b.rgba[k + channel]) > toleratedDifference;
        }
        outliers += far;
    }
    return outliers;
}

int compare(const char* foundPath, const char* expectedPath) {
    const cg::Pixels found = cg::readImage(foundPath);
    const cg::Pixels expected = cg::readImage(expectedPath);
    if (found.width != expected.width || found.height != expected.height) {
        std::cerr << foundPath << " is " << found.width << " x " << found.height << ", expected "
                  << expected.width << " x " << expected.height << "\n";
        return 1;
    }
    const long outliers = countOutliers(found, expected);
    const double pixels = static_cast<double>(found.width) * found.height;
    std::cout << outliers << " of " << pixels << " pixels differ from " << expectedPath << "\n";
    return static_cast<double>(outliers) <= toleratedShare * pixels ? 0 : 1;
}

int printColours(const char* path) {
    const cg::Pixels pixels = cg::readImage(path);
    std::set<std::array<int, 3>> colours;
    for (std::size_t k = 0; k < pixels.rgba.size(); k += 4) {
        colours.insert({pixels.rgba[k], pixels.rgba[k + 1], pixels.rgba[k + 2]});
    }
    std::cout << colours.size() << "\n";
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: compare_pictures FOUND EXPECTED | --colours PICTURE\n";
        return 2;
    }
    try {
        const bool colours = std::string(argv[1]) == "--colours";
        return colours ? printColours(argv[2]) : compare(argv[1], argv[2]);
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << "\n";
        return 2;
    }
}
