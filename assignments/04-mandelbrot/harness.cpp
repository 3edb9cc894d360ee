// What the grader may ask of a student's shader: its functions one by one, its pictures as floats
// with uniforms set by the course, and its pictures as the window makes them.
#include <cg/FloatTarget.h>
#include <cg/ShaderProbe.h>
#include <runner/Harness.h>

#include <vector>

#include "scene.h"
#include "views.h"

namespace {

using course::View;

const char* const kVertexFile = "shaders/canvas.vert";
const char* const kFragmentFile = "shaders/mandelbrot.frag";

// One scene for all pictures: compiling a shader takes longer than drawing with it.
course::Scene& scene() {
    static course::Scene instance;
    static const bool ready = (instance.init(), true);
    (void)ready;
    return instance;
}

// Sets the members and draws, as the window does after a key.
void drawAsTheWindow(const View& view) {
    MandelbrotShader& shader = scene().shader;
    shader.center = view.center;
    shader.zoom = view.zoom;
    shader.maxiter = view.maxiter;
    scene().draw();
}

cg::Uniforms uniformsOf(const View& view) {
    cg::Uniforms uniforms;
    uniforms.vec2s["center"] = view.center;
    uniforms.floats["zoom"] = view.zoom;
    uniforms.ints["maxiter"] = view.maxiter;
    return uniforms;
}

std::vector<glm::vec4> packed(const std::vector<glm::vec2>& first,
                              const std::vector<glm::vec2>& second) {
    std::vector<glm::vec4> all;
    for (std::size_t i = 0; i < first.size(); ++i) {
        all.emplace_back(first[i], second.at(i));
    }
    return all;
}

// Red, green and blue; alpha is nobody's business.
std::vector<glm::vec3> colours(const std::vector<glm::vec4>& values) {
    return {values.begin(), values.end()};
}

std::vector<glm::vec2> products(const std::vector<glm::vec2>& a, const std::vector<glm::vec2>& b) {
    std::vector<glm::vec2> results;
    for (const glm::vec4& each : cg::probeFunction(
             kFragmentFile, "cprod", "vec4(cprod(a.xy, a.zw), 0.0, 1.0)", packed(a, b), {})) {
        results.emplace_back(each);
    }
    return results;
}

std::vector<float> indices(const std::vector<glm::vec2>& c, int maxiter) {
    cg::Uniforms uniforms;
    uniforms.ints["maxiter"] = maxiter;
    std::vector<float> results;
    for (const glm::vec4& each : cg::probeFunction(
             kFragmentFile, "iterate", "vec4(float(iterate(a.xy)))", packed(c, c), uniforms)) {
        results.push_back(each.x);
    }
    return results;
}

// Pictures of one MandelbrotShader, one after the other, each side x side; row 0 at the bottom.
// Each of `views` is center.x, center.y, zoom, maxiter.
std::vector<glm::vec3> windowPictures(const std::vector<glm::vec4>& views, int side) {
    std::vector<glm::vec3> all;
    for (const glm::vec4& each : views) {
        const cg::FloatTarget target(side, side);
        drawAsTheWindow({glm::vec2(each), each.z, static_cast<int>(each.w)});
        for (const glm::vec4& colour : target.read()) {
            all.emplace_back(colour);
        }
    }
    return all;
}

}  // namespace

CG_HARNESS(harness) {
    harness.function(
        "cprod", [](std::vector<glm::vec2> a, std::vector<glm::vec2> b) { return products(a, b); });
    harness.function("iterate",
                     [](std::vector<glm::vec2> c, int maxiter) { return indices(c, maxiter); });
    // side x side colours, row 0 at the top.
    harness.function("picture", [](glm::vec2 center, float zoom, int maxiter, int side) {
        return colours(cg::renderFloat(kVertexFile, kFragmentFile, side, side,
                                       uniformsOf({center, zoom, maxiter})));
    });
    harness.function("windowPictures", [](std::vector<glm::vec4> views, int side) {
        return windowPictures(views, side);
    });

    harness.frame("whole-set", [](const FrameRequest&) { drawAsTheWindow(course::wholeSet); });
    harness.frame("seahorses", [](const FrameRequest&) { drawAsTheWindow(course::seahorses); });
    harness.frame("crown", [](const FrameRequest&) { drawAsTheWindow(course::crown); });
    harness.frame("few-steps", [](const FrameRequest&) { drawAsTheWindow(course::fewSteps); });
    harness.frame("seeded-rim", [](const FrameRequest& request) {
        SeededValues values(request.seed);
        drawAsTheWindow(course::drawnView(values));
    });
}
