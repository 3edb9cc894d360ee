// Flat, Gouraud and Phong shading of one coarse sphere side by side, as in figure 10.1. For the
// first two, your fragment shader is asked for a few colours only: one at the middle of each
// triangle, or one at each corner. Only the window includes this file.
#pragma once

#include <cg/ShaderProbe.h>
#include <cg/gl.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene.h"

namespace course {

/// Triangles that share no corner: attribute 0 the positions, attribute 1 whatever is asked for
/// (normals or colours), three floats a corner.
class Triangles : public Geometry {
public:
    void fill(const std::vector<glm::vec3>& positions, const std::vector<glm::vec3>& others) {
        std::vector<GLuint> indices(positions.size());
        for (std::size_t i = 0; i < indices.size(); ++i) {
            indices[i] = static_cast<GLuint>(i);
        }
        build({{3, flattened(positions)}, {3, flattened(others)}}, indices);
    }

private:
    static std::vector<GLfloat> flattened(const std::vector<glm::vec3>& all) {
        std::vector<GLfloat> floats;
        for (const glm::vec3& each : all) {
            floats.insert(floats.end(), {each.x, each.y, each.z});
        }
        return floats;
    }
};

class Comparison {
public:
    /// After Set::init, with the context current.
    void init() {
        makeSphere();
        phong_.fill(corners_, normals_);
        painter_.vertexshader_source =
            "#version 330 core\n"
            "layout (location = 0) in vec3 vertex_position;\n"
            "layout (location = 1) in vec3 vertex_color;\n"
            "uniform mat4 transform;\n"
            "out vec3 color;\n"
            "void main() {\n"
            "    color = vertex_color;\n"
            "    gl_Position = transform * vec4(vertex_position, 1.0);\n"
            "}\n";
        painter_.fragmentshader_source =
            "#version 330 core\n"
            "in vec3 color;\n"
            "out vec4 fragColor;\n"
            "void main() { fragColor = vec4(color, 1.0); }\n";
        painter_.compile();
    }

    /// Clears the picture; draws flat, Gouraud and Phong shading from left to right.
    void draw(Set& set, const glm::mat4& view, const glm::mat4& projection,
              const std::vector<Light>& lights, Material& material) {
        set.draw(view, projection, lights, {{&phong_, placed(1.0f), &material}});
        const auto atMiddle = shaded(set.shader, view * placed(-1.0f), middles_, facing_);
        std::vector<glm::vec3> flat;
        for (const glm::vec3& color : atMiddle) {
            flat.insert(flat.end(), 3, color);
        }
        paint(projection * view * placed(-1.0f), flat);
        paint(projection * view * placed(0.0f),
              shaded(set.shader, view * placed(0.0f), corners_, normals_));
    }

private:
    static glm::mat4 placed(float column) {
        const glm::vec3 where(1.15f * column, 0.15f, 0.0f);
        return glm::scale(glm::translate(glm::mat4(1.0f), where), glm::vec3(0.5f));
    }

    void makeSphere() {
        const int slices = 14, stacks = 8;
        const auto at = [&](int slice, int stack) {
            const float turn = 6.2831853f * float(slice) / float(slices);
            const float fall = 3.1415927f * float(stack) / float(stacks);
            return glm::vec3(std::sin(fall) * std::cos(turn), std::cos(fall),
                             -std::sin(fall) * std::sin(turn));
        };
        for (int stack = 0; stack < stacks; ++stack) {
            for (int slice = 0; slice < slices; ++slice) {
                const auto a = at(slice, stack), b = at(slice, stack + 1);
                const auto c = at(slice + 1, stack + 1), d = at(slice + 1, stack);
                if (stack + 1 < stacks) {
                    addTriangle({a, b, c});
                }
                if (stack > 0) {
                    addTriangle({a, c, d});
                }
            }
        }
    }
    void addTriangle(const std::array<glm::vec3, 3>& triangle) {
        corners_.insert(corners_.end(), triangle.begin(), triangle.end());
        normals_.insert(normals_.end(), triangle.begin(), triangle.end());
        middles_.push_back((triangle[0] + triangle[1] + triangle[2]) / 3.0f);
        facing_.push_back(glm::normalize(middles_.back()));
    }

    // What your shader says of these points of the model, with the uniforms of the last draw.
    static std::vector<glm::vec3> shaded(const LightingShader& shader, const glm::mat4& modelview,
                                         const std::vector<glm::vec3>& positions,
                                         const std::vector<glm::vec3>& normals) {
        cg::Uniforms uniforms;
        uniforms.mat4s = {{"view", shader.view}, {"modelview", modelview}};
        uniforms.vec4s = {{"ambient", shader.material->ambient},
                          {"diffuse", shader.material->diffuse},
                          {"specular", shader.material->specular},
                          {"emision", shader.material->emision}};
        uniforms.floats = {{"shininess", shader.material->shininess},
                           {"exposure", shader.exposure},
                           {"gamma", shader.gamma}};
        uniforms.ints = {{"nlights", shader.nlights}, {"enablelighting", shader.enablelighting}};
        uniforms.vec3s = {{"attenuation", shader.attenuation}};
        uniforms.vec4Arrays = {{"lightpositions", shader.lightpositions},
                               {"lightcolors", shader.lightcolors}};
        std::vector<glm::vec4> points, directions;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            points.push_back(glm::vec4(positions[i], 1.0f));
            directions.push_back(glm::vec4(normals[i], 0.0f));
        }
        std::vector<glm::vec3> colors;
        for (const glm::vec4& color :
             cg::probeFragment("shaders/lighting.frag",
                               {{"position", points}, {"normal", directions}}, uniforms)) {
            colors.push_back(glm::clamp(glm::vec3(color), 0.0f, 1.0f));
        }
        return colors;
    }

    void paint(const glm::mat4& transform, const std::vector<glm::vec3>& colors) {
        Triangles painted;
        painted.fill(corners_, colors);
        glUseProgram(painter_.program);
        glUniformMatrix4fv(glGetUniformLocation(painter_.program, "transform"), 1, GL_FALSE,
                           &transform[0][0]);
        painted.draw();
    }

    std::vector<glm::vec3> corners_, normals_;  // three a triangle
    std::vector<glm::vec3> middles_, facing_;   // one a triangle
    Triangles phong_;
    Shader painter_;
};

}  // namespace course
