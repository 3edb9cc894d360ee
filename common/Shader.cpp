#include "Shader.h"

#include <cg/Context.h>
#include <cg/Error.h>
#include <cg/GlslLog.h>
#include <cg/Ownership.h>
#include <cg/Resources.h>

#include <fstream>
#include <sstream>

namespace {

std::string readText(const char* name) {
    const std::string path = cg::findResource(name);
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) {
        throw cg::Error("cannot read the shader " + path);
    }
    const std::string result = text.str();
    const bool hasByteOrderMark = result.compare(0, 3, "\xEF\xBB\xBF") == 0;
    return hasByteOrderMark ? result.substr(3) : result;
}

GLuint requireObject(GLuint name) {
    if (name == 0) {
        throw cg::Error("Shader::compile: no OpenGL context is current");
    }
    return name;
}

/// One shader object, deleted with its owner.
class Stage {
public:
    explicit Stage(GLenum type) : name(requireObject(glCreateShader(type))) {}
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    ~Stage() { glDeleteShader(name); }

    GLint compile(const std::string& source) const {
        const GLchar* text = source.data();
        const auto length = static_cast<GLint>(source.size());
        glShaderSource(name, 1, &text, &length);
        glCompileShader(name);
        GLint status = 0;
        glGetShaderiv(name, GL_COMPILE_STATUS, &status);
        return status;
    }

    /// Sentence for an error message; empty when compiling went well.
    std::string complaint(GLint status, const std::string& file) const {
        if (status != 0) {
            return "";
        }
        GLint length = 0;
        glGetShaderiv(name, GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(length) + 1, '\0');
        glGetShaderInfoLog(name, length + 1, nullptr, log.data());
        return file + " does not compile:\n" + cg::nameGlslLog(log, file) + "\n";
    }

    const GLuint name;
};

/// One program object, deleted with its owner unless released.
class Program {
public:
    Program() : name(requireObject(glCreateProgram())) {}
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() { glDeleteProgram(name); }

    GLint link(const Stage& vertex, const Stage& fragment) const {
        glAttachShader(name, vertex.name);
        glAttachShader(name, fragment.name);
        glLinkProgram(name);
        glDetachShader(name, vertex.name);
        glDetachShader(name, fragment.name);
        GLint status = 0;
        glGetProgramiv(name, GL_LINK_STATUS, &status);
        return status;
    }

    std::string log() const {
        GLint length = 0;
        glGetProgramiv(name, GL_INFO_LOG_LENGTH, &length);
        std::string text(static_cast<std::size_t>(length) + 1, '\0');
        glGetProgramInfoLog(name, length + 1, nullptr, text.data());
        return text.substr(0, text.find('\0'));
    }

    GLuint release() {
        const GLuint released = name;
        name = 0;
        return released;
    }

private:
    GLuint name;
};

}  // namespace

Shader::~Shader() {
    if (program != 0 && cg::mayDelete(context)) {
        glDeleteProgram(program);
    }
}

void Shader::read_source(const char* vertexshader_filename, const char* fragmentshader_filename) {
    std::string vertex = readText(vertexshader_filename);
    std::string fragment = readText(fragmentshader_filename);
    vertexshader_source = std::move(vertex);
    fragmentshader_source = std::move(fragment);
    vertexshader_name = vertexshader_filename;
    fragmentshader_name = fragmentshader_filename;
}

void Shader::compile() {
    compiled_vs = compiled_fs = linked = 0;
    const Stage vertex(GL_VERTEX_SHADER);
    const Stage fragment(GL_FRAGMENT_SHADER);
    compiled_vs = vertex.compile(vertexshader_source);
    compiled_fs = fragment.compile(fragmentshader_source);
    const std::string complaints = vertex.complaint(compiled_vs, vertexshader_name) +
                                   fragment.complaint(compiled_fs, fragmentshader_name);
    if (!complaints.empty()) {
        throw cg::Error(complaints);
    }
    Program fresh;
    linked = fresh.link(vertex, fragment);
    if (linked == 0) {
        throw cg::Error(vertexshader_name + " and " + fragmentshader_name + " do not link:\n" +
                        fresh.log());
    }
    if (program != 0 && cg::mayDelete(context)) {
        glDeleteProgram(program);
    }
    program = fresh.release();
    context = cg::currentContextId();
}
