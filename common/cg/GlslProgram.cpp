#include <cg/GlslLog.h>
#include <cg/GlslProgram.h>
#include <cg/Resources.h>
#include <cg/Todo.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

namespace cg {
namespace {

GLuint requireObject(GLuint name) {
    if (name == 0) {
        throw Error("GLSL: no OpenGL context is current");
    }
    return name;
}

/// Up to the NUL that ends a log of GL's.
std::string upToNul(std::string text) {
    return text.substr(0, text.find('\0'));
}

}  // namespace

std::string readShaderFile(const std::string& name) {
    const std::string path = findResource(name);
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) {
        throw Error("cannot read the shader " + path);
    }
    const std::string result = text.str();
    return result.compare(0, 3, "\xEF\xBB\xBF") == 0 ? result.substr(3) : result;
}

GlslStage::GlslStage(GLenum type, const std::string& source, std::string file)
    : name_(requireObject(glCreateShader(type))), source_(source), file_(std::move(file)) {
    const GLchar* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    glShaderSource(name_, 1, &text, &length);
    glCompileShader(name_);
    glGetShaderiv(name_, GL_COMPILE_STATUS, &compiled_);
}

std::string GlslStage::complaint() const {
    if (compiled_ != 0) {
        return "";
    }
    GLint length = 0;
    glGetShaderiv(name_, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length) + 1, '\0');
    glGetShaderInfoLog(name_, length + 1, nullptr, text.data());
    const std::string log = upToNul(text);
    const std::string named = nameGlslLog(log, file_);
    const std::string hint = glslHint(log, source_);
    return file_ + " does not compile:\n" + named + "\n" +
           (hint.empty() ? "" : "hint: " + hint + "\n");
}

GlslProgram::GlslProgram() : name_(requireObject(glCreateProgram())) {}

void GlslProgram::capture(const std::vector<std::string>& varyings) const {
    std::vector<const GLchar*> names;
    for (const std::string& each : varyings) {
        names.push_back(each.c_str());
    }
    glTransformFeedbackVaryings(name_, static_cast<GLsizei>(names.size()), names.data(),
                                GL_INTERLEAVED_ATTRIBS);
}

void GlslProgram::link(const std::vector<const GlslStage*>& stages) const {
    std::string complaints, files;
    for (const GlslStage* stage : stages) {
        complaints += stage->complaint();
        files += (files.empty() ? "" : " and ") + stage->file();
    }
    if (!complaints.empty()) {
        throw GlslError(complaints);
    }
    for (const GlslStage* stage : stages) {
        glAttachShader(name_, stage->name());
    }
    glLinkProgram(name_);
    for (const GlslStage* stage : stages) {
        glDetachShader(name_, stage->name());
    }
    GLint linked = 0;
    glGetProgramiv(name_, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        throw GlslError(files + (stages.size() > 1 ? " do" : " does") + " not link:\n" + log());
    }
    reportShaderTodos(name_);
}

std::string GlslProgram::log() const {
    GLint length = 0;
    glGetProgramiv(name_, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length) + 1, '\0');
    glGetProgramInfoLog(name_, length + 1, nullptr, text.data());
    return upToNul(text);
}

GLuint GlslProgram::release() {
    const GLuint released = name_;
    name_ = 0;
    return released;
}

void reportShaderTodos(GLuint program) {
    const std::string prefix = "cg_todo_";
    GLint count = 0;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<GLchar, 256> name{};
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(program, static_cast<GLuint>(i), static_cast<GLsizei>(name.size()),
                           nullptr, &size, &type, name.data());
        std::string id = name.data();
        if (id.compare(0, prefix.size(), prefix) != 0) {
            continue;
        }
        id.erase(0, prefix.size());
        std::replace(id.begin(), id.end(), '_', '-');
        todo(id.c_str());
    }
}

}  // namespace cg
