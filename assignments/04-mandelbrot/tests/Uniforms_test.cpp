// The MandelbrotShader class, used as the window does: compile(), glUseProgram, initUniforms(), and
// before every picture the members are set and setUniforms() is called.
#include "levels.h"

using namespace judge;
using course::View;

namespace {

using Picture = std::vector<glm::vec3>;

/// Pictures of one MandelbrotShader, one after the other.
std::vector<Picture> windowPictures(const std::vector<View>& views) {
    std::vector<glm::vec4> packed;
    for (const View& view : views)
        packed.emplace_back(view.center, view.zoom, float(view.maxiter));
    const Picture all = subject().shade<Picture>("windowPictures", packed, levels::kSide);
    needCount("windowPictures", all.size(), views.size() * levels::kSide * levels::kSide);
    levels::observeEdges(all);
    std::vector<Picture> pictures(views.size());
    for (std::size_t i = 0; i < views.size(); ++i)
        for (int row = levels::kSide - 1; row >= 0; --row) {  // the first row is at the bottom
            const auto from =
                all.begin() + (std::ptrdiff_t(i) * levels::kSide + row) * levels::kSide;
            pictures[i].insert(pictures[i].end(), from, from + levels::kSide);
        }
    return pictures;
}

/// Whether the pictures are those that the shader draws when the course sets the uniforms, and not
/// all the same. Then the uniforms are right, whatever the shader makes of them.
bool follow(const std::vector<View>& views, const std::vector<Picture>& pictures) {
    for (std::size_t i = 0; i < views.size(); ++i)
        if (!levels::areAlike(pictures[i], levels::pictureOf(views[i])) ||
            levels::areAlike(pictures[i], pictures[(i + 1) % views.size()]))
            return false;
    return true;
}

/// Fails unless every picture has the level sets of its view, or at least follows the uniforms.
void expectWindow(const std::vector<View>& views) {
    const std::vector<Picture> pictures = windowPictures(views);
    for (std::size_t i = 0; i < views.size(); ++i)
        if (const std::string found = levels::complaint(views[i], pictures[i]); !found.empty()) {
            if (!follow(views, pictures))
                fail(found);
            return;
        }
}

// What the members hold before anybody changes them, and the shader's uniforms as they are
// declared. A check of one uniform leaves the other two so: what does not arrive of them is another
// check's.
const View untouched = course::wholeSet;

std::vector<View> centers(const std::vector<glm::vec2>& values) {
    std::vector<View> views;
    for (const glm::vec2& value : values)
        views.push_back({value, untouched.zoom, untouched.maxiter});
    return views;
}

std::vector<View> zooms(const std::vector<float>& values) {
    std::vector<View> views;
    for (const float value : values)
        views.push_back({untouched.center, value, untouched.maxiter});
    return views;
}

std::vector<View> maxiters(const std::vector<int>& values) {
    std::vector<View> views;
    for (const int value : values)
        views.push_back({untouched.center, untouched.zoom, value});
    return views;
}

}  // namespace

TEST(Uniforms, Center) {
    check("center moves the picture, to the side and upwards",
          "glUniform2f(center_loc, center.x, center.y), with the location looked up by the name "
          "that the shader has.");
    expectWindow(centers({{-0.5f, 0.6f}, {-0.9f, -0.3f}, {0.2f, -0.5f}}));
}

TEST(Uniforms, Zoom) {
    check("zoom changes the size of what is seen",
          "zoom is a float: glUniform1f. glUniform1i is refused by GL and changes nothing.");
    expectWindow(zooms({1.5f, 0.8f, 3.0f}));
}

TEST(Uniforms, Maxiter) {
    check("maxiter changes the number of levels",
          "maxiter is an int: glUniform1i. glUniform1f is refused by GL and changes nothing.");
    expectWindow(maxiters({11, 70, 5}));
}

TEST(Uniforms, ThreePlaces) {
    check("three places drawn from the seed, one after the other, are all shown",
          "setUniforms() is called before every picture: hand over what the members hold then.");
    std::vector<View> views;
    for (int i = 0; i < 3; ++i)
        views.push_back(course::drawnView(judge::random()));
    expectWindow(views);
}
