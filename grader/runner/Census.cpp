#include "runner/Census.h"

#include <cg/gl.h>

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <utility>

namespace runner {

namespace {

constexpr std::size_t kMostCalls = 100000;

const cg::Context* target = nullptr;
thread_local DriverWork doing = DriverWork::none;
bool recording = false;
Census census;
std::map<GLint, bool> programsSeen;  ///< in this request: their todos are noted

template <class Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(target->function(name));
}

GLint integer(GLenum name) {
    GLint value = 0;
    real<PFNGLGETINTEGERVPROC>("glGetIntegerv")(name, &value);
    return value;
}

/// Reads a uniform into `into` (of the right size); false when the program has none of that name.
bool readUniform(GLint program, const char* name, float* into) {
    const GLint location = real<PFNGLGETUNIFORMLOCATIONPROC>("glGetUniformLocation")(
        static_cast<GLuint>(program), name);
    if (location >= 0)
        real<PFNGLGETUNIFORMFVPROC>("glGetUniformfv")(static_cast<GLuint>(program), location, into);
    return location >= 0;
}

/// An unfilled region of a shader keeps a uniform cg_todo_<id> active.
void noteTodos(GLint program) {
    const std::string prefix = "cg_todo_";
    GLint count = 0;
    real<PFNGLGETPROGRAMIVPROC>("glGetProgramiv")(static_cast<GLuint>(program), GL_ACTIVE_UNIFORMS,
                                                  &count);
    for (GLint i = 0; i < count; ++i) {
        char name[256] = "";
        GLint size = 0;
        GLenum type = 0;
        real<PFNGLGETACTIVEUNIFORMPROC>("glGetActiveUniform")(static_cast<GLuint>(program),
                                                              static_cast<GLuint>(i), sizeof name,
                                                              nullptr, &size, &type, name);
        std::string id = name;
        if (!id.starts_with(prefix))
            continue;
        id.erase(0, prefix.size());
        std::replace(id.begin(), id.end(), '_', '-');
        if (std::find(census.todos.begin(), census.todos.end(), id) == census.todos.end())
            census.todos.push_back(id);
    }
}

void note(GLsizei count) {
    if (!target)
        return;
    const GLint program = integer(GL_CURRENT_PROGRAM);
    if (program != 0 && !programsSeen[program]) {
        programsSeen[program] = true;
        noteTodos(program);
    }
    if (!recording || census.calls.size() >= kMostCalls)
        return;
    protocol::DrawCall call;
    call.vertexArray = static_cast<std::uint32_t>(integer(GL_VERTEX_ARRAY_BINDING));
    call.count = count;
    if (program != 0) {
        readUniform(program, "modelview", glm::value_ptr(call.modelview));
        const bool colours[] = {readUniform(program, "ambient", &call.ambient[0]),
                                readUniform(program, "diffuse", &call.diffuse[0]),
                                readUniform(program, "specular", &call.specular[0]),
                                readUniform(program, "emision", &call.emision[0])};
        call.hasMaterial =
            std::find(std::begin(colours), std::end(colours), true) != std::end(colours);
        readUniform(program, "shininess", &call.shininess);
    }
    census.calls.push_back(call);
}

/// Calls the driver. Where there is no context, nothing happens, as OpenGL has it.
template <class Function, class... Arguments>
void passOn(DriverWork work, const char* name, Arguments... arguments) {
    if (!target)
        return;
    doing = work;
    real<Function>(name)(arguments...);
    doing = DriverWork::none;
}

}  // namespace

DriverWork driverWork() {
    return doing;
}

void setCensusContext(const cg::Context* context) {
    target = context;
}

void beginCensus(bool recordCalls) {
    recording = recordCalls;
    census = {};
    programsSeen.clear();
}

Census takeCensus() {
    recording = false;
    return std::exchange(census, {});
}

}  // namespace runner

// The entry points that the subject is bound to; exported by DrawEntryPoints.list.
using runner::DriverWork;
using runner::note;
using runner::passOn;

extern "C" {

void APIENTRY glCompileShader(GLuint shader) {
    passOn<PFNGLCOMPILESHADERPROC>(DriverWork::shaders, "glCompileShader", shader);
}

void APIENTRY glLinkProgram(GLuint program) {
    passOn<PFNGLLINKPROGRAMPROC>(DriverWork::shaders, "glLinkProgram", program);
}

void APIENTRY glDrawArrays(GLenum mode, GLint first, GLsizei count) {
    note(count);
    passOn<PFNGLDRAWARRAYSPROC>(DriverWork::drawing, "glDrawArrays", mode, first, count);
}

void APIENTRY glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    note(count);
    passOn<PFNGLDRAWELEMENTSPROC>(DriverWork::drawing, "glDrawElements", mode, count, type,
                                  indices);
}

void APIENTRY glDrawRangeElements(GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                                  const void* indices) {
    note(count);
    passOn<PFNGLDRAWRANGEELEMENTSPROC>(DriverWork::drawing, "glDrawRangeElements", mode, start, end,
                                       count, type, indices);
}

void APIENTRY glDrawElementsBaseVertex(GLenum mode, GLsizei count, GLenum type, const void* indices,
                                       GLint baseVertex) {
    note(count);
    passOn<PFNGLDRAWELEMENTSBASEVERTEXPROC>(DriverWork::drawing, "glDrawElementsBaseVertex", mode,
                                            count, type, indices, baseVertex);
}

void APIENTRY glDrawArraysInstanced(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
    note(count);
    passOn<PFNGLDRAWARRAYSINSTANCEDPROC>(DriverWork::drawing, "glDrawArraysInstanced", mode, first,
                                         count, instances);
}

void APIENTRY glDrawElementsInstanced(GLenum mode, GLsizei count, GLenum type, const void* indices,
                                      GLsizei instances) {
    note(count);
    passOn<PFNGLDRAWELEMENTSINSTANCEDPROC>(DriverWork::drawing, "glDrawElementsInstanced", mode,
                                           count, type, indices, instances);
}

}  // extern "C"
