#include "Geometry.h"

#include <cg/Context.h>
#include <cg/Error.h>
#include <cg/Ownership.h>

namespace {

template <class Value>
void fill(GLenum target, GLuint buffer, const std::vector<Value>& values) {
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(),
                 GL_STATIC_DRAW);
}

}  // namespace

Geometry::~Geometry() {
    release();
}

void Geometry::draw() {
    glBindVertexArray(vao);
    glDrawElements(mode, count, type, nullptr);
}

void Geometry::build(std::initializer_list<Attribute> attributes,
                     const std::vector<GLuint>& indices) {
    release();
    glGenVertexArrays(1, &vao);
    if (vao == 0) {
        throw cg::Error("Geometry: init() needs a current OpenGL context");
    }
    context = cg::currentContextId();
    buffers.resize(attributes.size() + 1);
    glGenBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());

    glBindVertexArray(vao);
    GLuint location = 0;
    for (const Attribute& attribute : attributes) {
        fill(GL_ARRAY_BUFFER, buffers[location], attribute.values);
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, attribute.size, GL_FLOAT, GL_FALSE, 0, nullptr);
        ++location;
    }
    fill(GL_ELEMENT_ARRAY_BUFFER, buffers[location], indices);
    glBindVertexArray(0);
    count = static_cast<int>(indices.size());
}

void Geometry::release() {
    if ((vao != 0 || !buffers.empty()) && cg::mayDelete(context)) {
        glDeleteVertexArrays(1, &vao);
        glDeleteBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    }
    vao = 0;
    buffers.clear();
    count = 0;
    context = 0;
}
