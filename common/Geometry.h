#pragma once

#include <cg/gl.h>

#include <initializer_list>
#include <vector>

/// Something that can be drawn: a vertex array object with its buffers (sections 4.1, 7.6.4).
/// Derived classes fill it in init(), which needs a current context; so does draw(). Owns its GL
/// objects; not copyable. Its destructor may run at any time, with or without a context.
class Geometry {
public:
    GLenum mode = GL_TRIANGLES;     ///< what the indices are grouped into
    int count = 0;                  ///< number of indices; nothing is drawn before init()
    GLenum type = GL_UNSIGNED_INT;  ///< type of one index
    GLuint vao = 0;                 ///< vertex array object, 0 before init()
    std::vector<GLuint> buffers;    ///< one per attribute, then the indices

    Geometry() = default;
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;
    virtual ~Geometry();

    virtual void init() {}                              ///< a shape without parameters
    virtual void init(const char* /*file_or_name*/) {}  ///< a shape read from a file

    /// Draws all of it with the program in use.
    void draw();

protected:
    /// One column of the vertex table: `size` floats (1 to 4) per vertex, one vertex after another.
    struct Attribute {
        GLint size;
        std::vector<GLfloat> values;
    };

    /// Makes vao, buffers and count anew: attribute k at location k, and the index list. What an
    /// earlier call made is deleted. Throws cg::Error when no context is current.
    void build(std::initializer_list<Attribute> attributes, const std::vector<GLuint>& indices);

private:
    void release();

    unsigned context = 0;  // that the objects belong to, 0 when a derived class made them itself
};
