#pragma once

#include <cg/Error.h>

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

/// Shaders as functions: values in, values out, no picture to compare. Many inputs go through one
/// draw. A context must be current; its framebuffer, viewport and clear colour are as before
/// afterwards. All throw cg::GlslError with the file's own name and line when a shader does not
/// compile, and cg::Error when a file is missing.
namespace cg {

/// The shader file has no function of that name.
struct MissingFunction : Error {
    using Error::Error;
};

/// Uniform values set before the draw. A name that the program does not use is ignored.
struct Uniforms {
    std::map<std::string, float> floats;
    std::map<std::string, int> ints;  ///< bool uniforms, too
    std::map<std::string, glm::vec2> vec2s;
    std::map<std::string, glm::vec3> vec3s;
    std::map<std::string, glm::vec4> vec4s;
    std::map<std::string, glm::mat3> mat3s;
    std::map<std::string, glm::mat4> mat4s;
    std::map<std::string, std::vector<glm::vec4>> vec4Arrays;
};

/// The first output of a fragment shader for each set of inputs: unclamped 32-bit floats. `inputs`
/// gives each `in` variable of the shader (float to vec4) one value a fragment; components that
/// the variable lacks are ignored. All lists must be equally long, 1 to 16384.
std::vector<glm::vec4> probeFragment(const std::string& file,
                                     const std::map<std::string, std::vector<glm::vec4>>& inputs,
                                     const Uniforms& uniforms);

/// A vec4 `expression` over a function of a shader file, for instance
/// "vec4(cprod(a.xy, a.zw), 0.0, 1.0)"; `a` is the input of each evaluation. The file's own main is
/// put aside. Throws MissingFunction when the file does not define `function`.
std::vector<glm::vec4> probeFunction(const std::string& file, const std::string& function,
                                     const std::string& expression,
                                     const std::vector<glm::vec4>& inputs,
                                     const Uniforms& uniforms);

/// A varying of a vertex shader (float to vec4, filled up with 0), one value a vertex, by transform
/// feedback. `attributes` by location. Nothing is rasterised.
std::vector<glm::vec4> probeVertex(const std::string& file,
                                   const std::map<unsigned, std::vector<glm::vec4>>& attributes,
                                   const std::string& output, const Uniforms& uniforms);

/// What a fragment shader draws over a square that fills the picture (Square.h, through the vertex
/// shader `vertexFile`): width x height unclamped values, row 0 at the top.
std::vector<glm::vec4> renderFloat(const std::string& vertexFile, const std::string& fragmentFile,
                                   int width, int height, const Uniforms& uniforms);

}  // namespace cg
