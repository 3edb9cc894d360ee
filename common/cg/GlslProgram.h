#pragma once

#include <cg/Error.h>
#include <cg/gl.h>

#include <string>
#include <vector>

/// GLSL shaders and programs that delete themselves; what Shader and the shader probes stand on.
namespace cg {

/// A shader does not compile or a program does not link. The text holds the compiler's log with
/// every place as "file:line: message", and a hint where the fault is a usual one.
struct GlslError : Error {
    using Error::Error;
};

/// Text of a shader file, looked up by findResource; a byte-order mark is taken off.
/// Throws cg::Error when it is missing or unreadable.
std::string readShaderFile(const std::string& name);

/// One shader object, compiled when made. Needs a current context.
class GlslStage {
public:
    GlslStage(GLenum type, const std::string& source, std::string file);
    GlslStage(const GlslStage&) = delete;
    GlslStage& operator=(const GlslStage&) = delete;
    ~GlslStage() { glDeleteShader(name_); }

    GLuint name() const { return name_; }
    const std::string& file() const { return file_; }
    GLint compiled() const { return compiled_; }  ///< 1 or 0, as GL has it

    /// What to tell the author; empty when it compiled.
    std::string complaint() const;

private:
    GLuint name_;
    std::string source_, file_;
    GLint compiled_ = 0;
};

/// One program object.
class GlslProgram {
public:
    GlslProgram();
    GlslProgram(const GlslProgram&) = delete;
    GlslProgram& operator=(const GlslProgram&) = delete;
    ~GlslProgram() { glDeleteProgram(name_); }

    GLuint name() const { return name_; }

    /// Varyings to capture in transform feedback; before link().
    void capture(const std::vector<std::string>& varyings) const;

    /// Links, and reports unfilled regions of the shaders (see reportShaderTodos). Throws
    /// GlslError with all complaints when a stage did not compile or linking failed.
    void link(const std::vector<const GlslStage*>& stages) const;

    /// Gives the object away.
    GLuint release();

private:
    std::string log() const;

    GLuint name_;
};

/// An unfilled region of a shader reads the uniform cg_todo_<id> (with _ for -), which is always 0.
/// Calls todo(id) for each such uniform that the linked program has active.
void reportShaderTodos(GLuint program);

}  // namespace cg
