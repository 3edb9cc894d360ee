#pragma once

#include <cg/gl.h>

#include <string>

/// A GLSL program made of a vertex and a fragment shader (section 4.2):
///     shader.read_source("shaders/projective.vert", "shaders/normal.frag");
///     shader.compile();
///     glUseProgram(shader.program);
/// Derived classes add the uniforms (see cg/NormalShader.h). Owns its program; not copyable.
class Shader {
public:
    GLuint program = 0;                 ///< 0 until compile() has succeeded
    std::string vertexshader_source;    ///< GLSL text, by read_source() or set directly
    std::string fragmentshader_source;  ///< GLSL text, by read_source() or set directly

    Shader() = default;
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    virtual ~Shader();

    /// Reads both sources. Names are looked up by cg::findResource: current folder first.
    /// Throws cg::Error when a file is missing or unreadable; both sources are then as before.
    void read_source(const char* vertexshader_filename, const char* fragmentshader_filename);

    /// Compiles and links; needs a current context. May be called again, for instance after an
    /// edit: the former program is then deleted (by GL, as soon as it is no longer in use).
    /// Throws cg::GlslError with the compiler's log, every place as "file:line: message"; `program`
    /// then still is the former one, and no GL object is left behind.
    void compile();

    /// 1 when the step of the latest compile() succeeded, else 0.
    GLint getVertexShaderCompileStatus() const { return compiled_vs; }
    GLint getFragmentShaderCompileStatus() const { return compiled_fs; }
    GLint getLinkStatus() const { return linked; }

private:
    GLint compiled_vs = 0;
    GLint compiled_fs = 0;
    GLint linked = 0;
    std::string vertexshader_name = "vertex shader";  // for messages: the file's name
    std::string fragmentshader_name = "fragment shader";
    unsigned context = 0;  // that `program` belongs to
};
