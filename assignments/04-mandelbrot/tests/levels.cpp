#include "levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

using namespace judge;

namespace levels {

namespace {

constexpr int kInside = -1;  ///< told apart from a first step escape here: they may look different
constexpr int kFewest = 4;  ///< pixels of a level set whose colour is compared with its neighbour's
constexpr int kGrid = 4;    ///< pixels between those whose colours are compared for the evidence
constexpr float kSame = 1e-5f;  ///< largest difference within one colour; two levels may have less

template <class Real>
int levelOf(Real cx, Real cy, int maxiter) {
    Real x = 0, y = 0;
    for (int k = 0; k < maxiter; ++k) {
        const Real next = x * x - y * y + cx;
        y = 2 * x * y + cy;
        x = next;
        if (x * x + y * y > 4)
            return k;
    }
    return kInside;
}

int levelOf(const glm::vec2& c, int maxiter) {
    return levelOf(double(c.x), double(c.y), maxiter);
}

bool isSame(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 difference = glm::abs(a - b);
    return std::max({difference.x, difference.y, difference.z}) <= kSame;  // false for NaN
}

struct Pixel {
    glm::vec2 c;
    int level;
    glm::vec3 colour;
};

/// The pixels whose level is beyond doubt.
std::vector<Pixel> firmPixels(const View& view, const std::vector<glm::vec3>& picture) {
    std::vector<Pixel> pixels;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column) {
            const glm::vec2 c = pointOf(view, column, row);
            if (isFirm(c, view.maxiter, view.zoom))
                pixels.push_back({c, levelOf(c, view.maxiter),
                                  picture.at(static_cast<std::size_t>(row * kSide + column))});
        }
    return pixels;
}

struct LevelSet {
    std::map<std::array<float, 3>, int> counts;
    int pixels = 0;
    glm::vec3 colour{0.0f};  ///< of most of its pixels
};

std::map<int, LevelSet> levelSetsOf(const std::vector<Pixel>& pixels) {
    std::map<int, LevelSet> sets;
    for (const Pixel& pixel : pixels) {
        LevelSet& set = sets[pixel.level];
        ++set.pixels;
        const glm::vec3& colour = pixel.colour;
        if (std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z))
            ++set.counts[{colour.x, colour.y, colour.z}];
    }
    for (auto& [level, set] : sets) {
        const auto most =
            std::max_element(set.counts.begin(), set.counts.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        if (most != set.counts.end())
            set.colour = {most->first[0], most->first[1], most->first[2]};
    }
    return sets;
}

std::string nameOf(int level) {
    return level == kInside ? "the inside" : say("level {}", level);
}

}  // namespace

int index(const glm::vec2& c, int maxiter) {
    return std::max(0, levelOf(c, maxiter));
}

glm::vec2 pointOf(const View& view, int column, int row) {
    const auto place = [](int i) { return float(2 * i + 1) / float(kSide) - 1.0f; };
    return view.center + view.zoom * glm::vec2(place(column), -place(row));
}

bool isFirm(const glm::vec2& c, int maxiter, float zoom) {
    const int level = levelOf(c, maxiter);
    const double step = 5e-7 * double(zoom + std::abs(c.x) + std::abs(c.y));
    for (const glm::dvec2& way : {glm::dvec2(1, 1), glm::dvec2(-1, 1), glm::dvec2(0.3, -1.2)})
        if (levelOf(double(c.x) + step * way.x, double(c.y) + step * way.y, maxiter) != level)
            return false;
    return levelOf<float>(c.x, c.y, maxiter) == level;
}

void observeEdges(const std::vector<glm::vec3>& pictures) {
    const int rows = static_cast<int>(pictures.size()) / kSide;
    std::vector<double> edges;
    const auto colour = [&](int row, int column) {
        return pictures.at(static_cast<std::size_t>(row * kSide + column));
    };
    for (int row = 0; row + kGrid < rows; row += kGrid)
        for (int column = 0; column + kGrid < kSide; column += kGrid) {
            edges.push_back(isSame(colour(row, column), colour(row, column + kGrid)) ? 0 : 1);
            edges.push_back(isSame(colour(row, column), colour(row + kGrid, column)) ? 0 : 1);
        }
    observed("shares", edges);
}

std::string tell(const View& view) {
    return say("center {}, zoom {}, maxiter {}", view.center, view.zoom, view.maxiter);
}

std::string complaint(const View& view, const std::vector<glm::vec3>& picture) {
    const std::vector<Pixel> pixels = firmPixels(view, picture);
    const std::map<int, LevelSet> sets = levelSetsOf(pixels);
    int outliers = 0;
    const Pixel* first = nullptr;
    for (const Pixel& pixel : pixels)
        if (!isSame(pixel.colour, sets.at(pixel.level).colour)) {
            ++outliers;
            first = first ? first : &pixel;
        }
    if (first && outliers > kOutliers * kSide * kSide) {
        return say(
            "with {} every level set has one colour: expected {} at c = {}, the colour of most "
            "of {}, got {}; so it is with {} of {} pixels",
            tell(view), sets.at(first->level).colour, first->c, nameOf(first->level), first->colour,
            outliers, kSide * kSide);
    }
    for (auto set = sets.begin(); set != sets.end(); ++set) {
        const auto next = sets.find(set->first + 1);
        if (set->first == kInside || next == sets.end() || set->second.pixels < kFewest ||
            next->second.pixels < kFewest)
            continue;
        if (set->second.colour == next->second.colour) {
            return say("with {} neighbouring levels have different colours: {} and {} both are {}",
                       tell(view), nameOf(set->first), nameOf(next->first), set->second.colour);
        }
    }
    return "";
}

bool areAlike(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    int different = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        different += isSame(a[i], b.at(i)) ? 0 : 1;
    return different <= kOutliers * kSide * kSide;
}

std::vector<glm::vec3> pictureOf(const View& view) {
    auto picture = subject().shade<std::vector<glm::vec3>>("picture", view.center, view.zoom,
                                                           view.maxiter, kSide);
    needCount("picture", picture.size(), kSide * kSide);
    observeEdges(picture);
    return picture;
}

bool expectPicture(const View& view) {
    const std::string found = complaint(view, pictureOf(view));
    if (!found.empty())
        fail(found);
    return found.empty();
}

bool expectLastStepSeen(const glm::vec2& center, float zoom, int first) {
    for (int maxiter = first; maxiter < first + 3; ++maxiter) {
        const View view{center, zoom, maxiter};
        const std::vector<glm::vec3> picture = pictureOf(view);
        if (const std::string found = complaint(view, picture);
            maxiter == first && !found.empty()) {
            fail(found);
            return false;
        }
        const std::map<int, LevelSet> sets = levelSetsOf(firmPixels(view, picture));
        if (!isSame(sets.at(kInside).colour, sets.at(maxiter - 1).colour))
            return true;
    }
    fail(
        say("with center {}, zoom {} and maxiter {}, {} and {}, c of I(c) = maxiter - 1 is not "
            "inside the set: expected another colour, got that of the inside",
            center, zoom, first, first + 1, first + 2));
    return false;
}

void expectIndices(const std::vector<glm::vec2>& points, int maxiter, const View& instead,
                   const std::string& which) {
    const auto got = valuesOf<std::vector<float>>("iterate", points, maxiter);
    if (!got) {
        expectPicture(instead);
        return;
    }
    needCount("iterate", got->size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float expected = static_cast<float>(index(points[i], maxiter));
        if (!expectClose(which + say("I(c) for c = {} and maxiter {}", points[i], maxiter),
                         got->at(i), expected, 1e-6f))
            return;
    }
}

}  // namespace levels
