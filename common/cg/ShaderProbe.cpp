#include <cg/Context.h>
#include <cg/FloatTarget.h>
#include <cg/GlslProgram.h>
#include <cg/GlslSource.h>
#include <cg/ShaderProbe.h>

#include <glm/gtc/type_ptr.hpp>
#include <memory>
#include <regex>

#include "Square.h"

namespace cg {
namespace {

using Values = std::vector<glm::vec4>;

void setUniforms(GLuint program, const Uniforms& uniforms) {
    const auto each = [program](const auto& values, auto&& set) {
        for (const auto& [name, value] : values) {
            const GLint location = glGetUniformLocation(program, name.c_str());
            if (location >= 0) {
                set(location, value);
            }
        }
    };
    glUseProgram(program);
    each(uniforms.floats, [](GLint at, float v) { glUniform1f(at, v); });
    each(uniforms.ints, [](GLint at, int v) { glUniform1i(at, v); });
    each(uniforms.vec2s, [](GLint at, const glm::vec2& v) { glUniform2fv(at, 1, &v[0]); });
    each(uniforms.vec3s, [](GLint at, const glm::vec3& v) { glUniform3fv(at, 1, &v[0]); });
    each(uniforms.vec4s, [](GLint at, const glm::vec4& v) { glUniform4fv(at, 1, &v[0]); });
    each(uniforms.mat3s, [](GLint at, const glm::mat3& v) {
        glUniformMatrix3fv(at, 1, GL_FALSE, glm::value_ptr(v));
    });
    each(uniforms.mat4s, [](GLint at, const glm::mat4& v) {
        glUniformMatrix4fv(at, 1, GL_FALSE, glm::value_ptr(v));
    });
    each(uniforms.vec4Arrays, [](GLint at, const Values& v) {
        if (!v.empty()) {
            glUniform4fv(at, static_cast<GLsizei>(v.size()), &v[0][0]);
        }
    });
}

/// A vertex array with one buffer of vec4 per attribute, deleted at the end.
class Points {
public:
    explicit Points(const std::map<unsigned, Values>& attributes) {
        glGenVertexArrays(1, &array_);
        glBindVertexArray(array_);
        for (const auto& [location, values] : attributes) {
            if (count_ != 0 && values.size() != count_) {
                throw Error("a shader probe needs inputs of equal length");
            }
            count_ = values.size();
            buffers_.push_back(0);
            glGenBuffers(1, &buffers_.back());
            glBindBuffer(GL_ARRAY_BUFFER, buffers_.back());
            glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count_ * sizeof(glm::vec4)),
                         values.data(), GL_STREAM_DRAW);
            glEnableVertexAttribArray(location);
            glVertexAttribPointer(location, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
        }
    }
    Points(const Points&) = delete;
    Points& operator=(const Points&) = delete;
    ~Points() {
        glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
        glDeleteVertexArrays(1, &array_);
    }

    std::size_t count() const { return count_; }
    void draw() const { glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count_)); }

private:
    GLuint array_ = 0;
    std::vector<GLuint> buffers_;
    std::size_t count_ = 0;
};

std::string componentsOf(const std::string& type) {
    return type == "float" ? ".x" : type == "vec2" ? ".xy" : type == "vec3" ? ".xyz" : "";
}

const char* kPlacePoint =
    "    gl_Position = vec4((2.0 * float(gl_VertexID % 128) + 1.0) / 128.0 - 1.0,\n"
    "                       (2.0 * float(gl_VertexID / 128) + 1.0) / 128.0 - 1.0, 0.0, 1.0);\n";
constexpr int kGrid = 128;  // fragments a row and rows: each point is one pixel of its own

/// A vertex shader that hands each input down as it is and puts point i on pixel i.
std::string passingVertexShader(const std::string& fragmentSource,
                                const std::vector<std::string>& names) {
    std::string declarations, assignments;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string type = typeOfInput(fragmentSource, names[i]);
        if (type.empty()) {
            continue;  // the shader does not use this input
        }
        const std::string attribute = "cg_input_" + std::to_string(i);
        declarations += "layout(location = " + std::to_string(i) + ") in vec4 " + attribute +
                        ";\nout " + type + " " + names[i] + ";\n";
        assignments += "    " + names[i] + " = " + attribute + componentsOf(type) + ";\n";
    }
    return "#version 330 core\n" + declarations + "void main() {\n" + assignments + kPlacePoint +
           "}\n";
}

Values drawPoints(const GlslProgram& program, const std::map<unsigned, Values>& attributes,
                  const Uniforms& uniforms) {
    FloatTarget target(kGrid, kGrid);
    const Points points(attributes);
    if (points.count() > static_cast<std::size_t>(kGrid) * kGrid) {
        throw Error("a shader probe takes at most 16384 inputs");
    }
    setUniforms(program.name(), uniforms);
    points.draw();
    Values all = target.read();
    all.resize(points.count());
    return all;
}

/// The program that `make` links, made once per context and key: many sets of uniforms cost one
/// compilation. Kept until the process ends, when its context is gone anyway.
template <class Make>
const GlslProgram& programOnce(const std::string& key, Make make) {
    static auto& known = *new std::map<std::string, std::unique_ptr<GlslProgram>>;
    std::unique_ptr<GlslProgram>& program = known[std::to_string(currentContextId()) + "\n" + key];
    if (!program) {
        auto fresh = std::make_unique<GlslProgram>();
        make(*fresh);
        program = std::move(fresh);
    }
    return *program;
}

const GlslProgram& fragmentProgram(const std::string& file, const std::string& source,
                                   const std::vector<std::string>& inputNames) {
    const std::string vertexSource = passingVertexShader(source, inputNames);
    return programOnce("fragment " + file + "\n" + vertexSource + source, [&](GlslProgram& fresh) {
        glBindFragDataLocation(fresh.name(), 0, "cg_result");
        const GlslStage vertex(GL_VERTEX_SHADER, vertexSource, "probe.vert");
        const GlslStage fragment(GL_FRAGMENT_SHADER, source, file);
        fresh.link({&fragment, &vertex});
    });
}

const GlslProgram& vertexProgram(const std::string& file, const std::string& output) {
    const std::string source = readShaderFile(file);
    return programOnce("vertex " + output + " " + file + "\n" + source, [&](GlslProgram& fresh) {
        const GlslStage vertex(GL_VERTEX_SHADER, source, file);
        fresh.capture({output});
        fresh.link({&vertex});
    });
}

const GlslProgram& pictureProgram(const std::string& vertexFile, const std::string& fragmentFile) {
    const std::string vertexSource = readShaderFile(vertexFile);
    const std::string fragmentSource = readShaderFile(fragmentFile);
    return programOnce(
        "picture " + fragmentFile + "\n" + vertexSource + fragmentSource, [&](GlslProgram& fresh) {
            const GlslStage vertex(GL_VERTEX_SHADER, vertexSource, vertexFile);
            const GlslStage fragment(GL_FRAGMENT_SHADER, fragmentSource, fragmentFile);
            fresh.link({&fragment, &vertex});
        });
}

}  // namespace

Values probeFragment(const std::string& file, const std::map<std::string, Values>& inputs,
                     const Uniforms& uniforms) {
    const std::string source = readShaderFile(file);
    std::vector<std::string> names;
    std::map<unsigned, Values> attributes;
    for (const auto& [name, values] : inputs) {
        attributes[static_cast<unsigned>(names.size())] = values;
        names.push_back(name);
    }
    return drawPoints(fragmentProgram(file, source, names), attributes, uniforms);
}

Values probeFunction(const std::string& file, const std::string& function,
                     const std::string& expression, const Values& inputs,
                     const Uniforms& uniforms) {
    const std::string source = readShaderFile(file);
    const auto complain = [&] {  // of the file's own errors, in its own words
        const GlslStage alone(GL_FRAGMENT_SHADER, source, file);
        if (alone.compiled() == 0) {
            throw GlslError(alone.complaint());
        }
    };
    if (!definesFunction(source, function)) {
        complain();
        throw MissingFunction("`" + function + "` is defined nowhere in " + file);
    }
    const std::string probed =
        insertAfterVersion(source, "#define main cg_main_put_aside\n") +
        "\n#undef main\nin vec4 cg_argument;\nout vec4 cg_result;\n"
        "void main() {\n    cg_result = " +
        std::regex_replace(expression, std::regex(R"(\ba\b)"), "cg_argument") + ";\n}\n";
    try {
        return drawPoints(fragmentProgram(file, probed, {"cg_argument"}), {{0, inputs}}, uniforms);
    } catch (const GlslError&) {
        complain();
        throw;
    }
}

Values probeVertex(const std::string& file, const std::map<unsigned, Values>& attributes,
                   const std::string& output, const Uniforms& uniforms) {
    const GlslProgram& program = vertexProgram(file, output);
    GLsizei size = 0;
    GLenum type = 0;
    GLchar name[256];
    glGetTransformFeedbackVarying(program.name(), 0, sizeof name, nullptr, &size, &type, name);
    const std::size_t components = type == GL_FLOAT_VEC4   ? 4
                                   : type == GL_FLOAT_VEC3 ? 3
                                   : type == GL_FLOAT_VEC2 ? 2
                                   : type == GL_FLOAT      ? 1
                                                           : 0;
    if (components == 0 || size != 1) {
        throw GlslError(file + ": `out` variable " + output + " must be a float or a vector");
    }
    const Points points(attributes);
    setUniforms(program.name(), uniforms);
    std::vector<float> numbers(points.count() * components);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    const auto bytes = static_cast<GLsizeiptr>(numbers.size() * sizeof(float));
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    points.draw();
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, numbers.data());
    glDeleteBuffers(1, &buffer);

    Values values(points.count(), glm::vec4(0.0f));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        values[i / components][static_cast<glm::length_t>(i % components)] = numbers[i];
    }
    return values;
}

Values renderFloat(const std::string& vertexFile, const std::string& fragmentFile, int width,
                   int height, const Uniforms& uniforms) {
    const GlslProgram& program = pictureProgram(vertexFile, fragmentFile);
    FloatTarget target(width, height);
    Square square;
    square.init(glm::vec2(0.0f), 2.0f);
    setUniforms(program.name(), uniforms);
    square.draw();
    const Values upwards = target.read();
    Values values;
    for (int row = height - 1; row >= 0; --row) {  // GL counts rows from the bottom
        const auto first = upwards.begin() + static_cast<long>(row) * width;
        values.insert(values.end(), first, first + width);
    }
    return values;
}

}  // namespace cg
