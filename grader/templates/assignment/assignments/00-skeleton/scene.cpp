#include "scene.h"

namespace course {

void Polygon::init(const std::vector<glm::vec2>& corners) {
    std::vector<GLfloat> positions, colors;
    std::vector<GLuint> triangles;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const float way = float(i) / float(corners.size());
        positions.insert(positions.end(), {corners[i].x, corners[i].y});
        colors.insert(colors.end(), {1.0f - way, 0.3f, way});
        if (i >= 2) {
            triangles.insert(triangles.end(), {0, GLuint(i - 1), GLuint(i)});
        }
    }
    build({{2, positions}, {3, colors}}, triangles);
}

void Scene::init() {
    const glm::vec3 low(0.75f), high(0.9f);
    sheet_.init(glm::vec2(0.0f), 2.2f, low, low, high, high);
    shader_.read_source("shaders/flat.vert", "shaders/flat.frag");
    shader_.compile();
    scale_ = glGetUniformLocation(shader_.program, "scale");
}

void Scene::draw(const std::vector<glm::vec2>& corners, float aspect) {
    glClearColor(0.1f, 0.2f, 0.3f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(shader_.program);
    glUniform2f(scale_, 1.0f / (1.2f * aspect), 1.0f / 1.2f);
    sheet_.draw();
    polygon_.init(corners);
    polygon_.draw();
}

}  // namespace course
