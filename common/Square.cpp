#include "Square.h"

namespace {

const std::vector<GLuint> twoTriangles = {0, 1, 2, 0, 2, 3};

std::vector<GLfloat> corners(const glm::vec2 center, const GLfloat sidelength) {
    const glm::vec2 low = center - 0.5f * sidelength;
    const glm::vec2 high = center + 0.5f * sidelength;
    return {low.x, low.y, high.x, low.y, high.x, high.y, low.x, high.y};
}

}  // namespace

void Square::init(const glm::vec2 center, const GLfloat sidelength) {
    build({{2, corners(center, sidelength)}}, twoTriangles);
}

void Square::init(const glm::vec2 center, const GLfloat sidelength, const glm::vec3 color0,
                  const glm::vec3 color1, const glm::vec3 color2, const glm::vec3 color3) {
    std::vector<GLfloat> colors;
    for (const glm::vec3& color : {color0, color1, color2, color3}) {
        colors.insert(colors.end(), {color.r, color.g, color.b});
    }
    build({{2, corners(center, sidelength)}, {3, colors}}, twoTriangles);
}
