#include "Shader.h"

#include <cg/Context.h>
#include <cg/GlslProgram.h>
#include <cg/Ownership.h>

Shader::~Shader() {
    if (program != 0 && cg::mayDelete(context)) {
        glDeleteProgram(program);
    }
}

void Shader::read_source(const char* vertexshader_filename, const char* fragmentshader_filename) {
    std::string vertex = cg::readShaderFile(vertexshader_filename);
    std::string fragment = cg::readShaderFile(fragmentshader_filename);
    vertexshader_source = std::move(vertex);
    fragmentshader_source = std::move(fragment);
    vertexshader_name = vertexshader_filename;
    fragmentshader_name = fragmentshader_filename;
}

void Shader::compile() {
    compiled_vs = compiled_fs = linked = 0;
    const cg::GlslStage vertex(GL_VERTEX_SHADER, vertexshader_source, vertexshader_name);
    const cg::GlslStage fragment(GL_FRAGMENT_SHADER, fragmentshader_source, fragmentshader_name);
    compiled_vs = vertex.compiled();
    compiled_fs = fragment.compiled();
    cg::GlslProgram fresh;
    fresh.link({&vertex, &fragment});
    linked = 1;
    if (program != 0 && cg::mayDelete(context)) {
        glDeleteProgram(program);
    }
    program = fresh.release();
    context = cg::currentContextId();
}
