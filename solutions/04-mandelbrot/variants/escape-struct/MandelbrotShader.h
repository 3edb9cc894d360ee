// Each uniform is a call, kept in a list. No regions.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "Shader.h"

class MandelbrotShader : public Shader {
public:
    glm::vec2 center{0.0f};
    GLfloat zoom{2.0f};
    GLint maxiter{50};

    void initUniforms() {
        const auto at = [this](const char* name) { return glGetUniformLocation(program, name); };
        const GLint c = at("center"), z = at("zoom"), m = at("maxiter");
        calls_ = {[this, c] { glUniform2f(c, center.x, center.y); },
                  [this, z] { glUniform1f(z, zoom); }, [this, m] { glUniform1i(m, maxiter); }};
    }

    void setUniforms() {
        for (const auto& call : calls_) {
            call();
        }
    }

private:
    std::vector<std::function<void()>> calls_;
};
