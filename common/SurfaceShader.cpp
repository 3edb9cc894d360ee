#include "SurfaceShader.h"

#include <algorithm>

namespace {

constexpr int mostLights = 10;  // length of the uniform arrays

void setMatrix(GLint location, const glm::mat4& value) {
    glUniformMatrix4fv(location, 1, GL_FALSE, &value[0][0]);
}

void setColor(GLint location, const glm::vec4& value) {
    glUniform4fv(location, 1, &value[0]);
}

void setList(GLint location, const std::vector<glm::vec4>& values) {
    if (!values.empty()) {
        const auto count = std::min(static_cast<GLsizei>(values.size()), mostLights);
        glUniform4fv(location, count, &values[0][0]);
    }
}

}  // namespace

void SurfaceShader::initUniforms() {
    const auto find = [this](const char* name) { return glGetUniformLocation(program, name); };
    at_.view = find("view");
    at_.modelview = find("modelview");
    at_.projection = find("projection");
    at_.ambient = find("ambient");
    at_.diffuse = find("diffuse");
    at_.specular = find("specular");
    at_.emision = find("emision");
    at_.shininess = find("shininess");
    at_.enablelighting = find("enablelighting");
    at_.nlights = find("nlights");
    at_.lightpositions = find("lightpositions");
    at_.lightcolors = find("lightcolors");
}

void SurfaceShader::setUniforms() {
    setMatrix(at_.view, view);
    setMatrix(at_.modelview, modelview);
    setMatrix(at_.projection, projection);

    static const Material none;
    const Material& surface = material != nullptr ? *material : none;
    setColor(at_.ambient, surface.ambient);
    setColor(at_.diffuse, surface.diffuse);
    setColor(at_.specular, surface.specular);
    setColor(at_.emision, surface.emision);
    glUniform1f(at_.shininess, surface.shininess);

    glUniform1i(at_.enablelighting, enablelighting);
    glUniform1i(at_.nlights, std::min(nlights, mostLights));
    setList(at_.lightpositions, lightpositions);
    setList(at_.lightcolors, lightcolors);
}
