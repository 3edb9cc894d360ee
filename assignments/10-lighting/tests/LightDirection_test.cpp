// The unit vector from the surface to a light, (10.22) or (10.23). It is read back from the colours
// that three surfaces with different normals show: from their diffuse parts n.l, and again from
// their specular parts n.h with exponent 1. One of the two is enough, so that a mistake in the
// other costs nothing here.
#include "truth.h"

using namespace judge;
using namespace truth;

namespace {

struct Scene {
    mat4 view;  ///< world to camera coordinates
    vec3 p;     ///< the surface, camera coordinates
};

const Scene sceneA{rigid(70.0f, {0.5f, -0.8f, 0.3f}, {0.5f, -0.4f, -1.2f}), {0.6f, -0.4f, -3.5f}};
const Scene sceneB{rigid(-115.0f, {0.2f, 0.7f, 0.6f}, {-0.8f, 0.3f, 0.9f}), {-0.5f, 0.7f, -4.2f}};

// What three surfaces at the same place show, each with the axis of its own turn for a normal.
std::vector<Trial> surfacesUnder(const Scene& scene, const vec4& light) {
    std::vector<Trial> trials;
    for (const vec3& axis : axes) {
        Trial s;
        s.view = scene.view;
        s.modelview = rigid(-60.0f, axis, vec3(0.0f));
        addFragment(s, scene.p, axis);
        s.diffuse = {1.0f, 0.0f, 0.0f};
        s.specular = {0.0f, 1.0f, 0.0f};
        s.shininess = 1.0f;
        s.lights = {{light, vec3(1.0f)}};
        trials.push_back(s);
    }
    return trials;
}

void expectDirection(const Scene& scene, const vec4& light) {
    const auto trials = surfacesUnder(scene, light);
    const auto [n, v, l, d] = geometry(trials[0], trials[0].fragments[0], trials[0].lights[0]);
    const Colors got = gains(trials, Slip(loneOverlooked | normalReversed));
    const glm::dmat3 rows = glm::transpose(glm::dmat3(axes[0], axes[1], axes[2]));
    const dvec3 byDiffuse = glm::inverse(rows) * dvec3(got[0].r, got[1].r, got[2].r);
    const dvec3 h = glm::normalize(glm::inverse(rows) * dvec3(got[0].g, got[1].g, got[2].g));
    const dvec3 bySpecular = 2.0 * glm::dot(h, v) * h - v;
    if (!close(byDiffuse, l) && !close(bySpecular, l))
        fail(say(
            "direction from the surface at {} to the light {} (world coordinates), seen by the "
            "camera: expected {}, got {}",
            vec3(glm::inverse(scene.view) * vec4(scene.p, 1.0f)), light, vec3(l), vec3(byDiffuse)));
}

// A light in the direction l (camera coordinates), written with this w.
vec4 towards(const Scene& scene, const vec3& l, float distance, float w) {
    return inWorld(scene.view, w == 0.0f ? distance * l : w * (scene.p + distance * l), w);
}

const vec3 ahead = glm::normalize(vec3(0.15f, 0.2f, 0.95f));
const vec3 beside = glm::normalize(vec3(-0.1f, 0.1f, 0.9f));

}  // namespace

TEST(LightDirection, AtInfinity) {
    check("a light at infinity shines along one direction, of whatever length it is written",
          "With w = 0 only the rotation of view acts on the light; (10.23) needs no if.");
    expectDirection(sceneA, towards(sceneA, ahead, 1.0f, 0.0f));
    expectDirection(sceneB, towards(sceneB, beside, 3.0f, 0.0f));
}

TEST(LightDirection, Point) {
    check("a light at a point shines from there to the surface",
          "l goes from the surface's position to the light; both in the same coordinates.");
    expectDirection(sceneA, towards(sceneA, beside, 1.4f, 1.0f));
    expectDirection(sceneB, towards(sceneB, ahead, 3.1f, 1.0f));
}

TEST(LightDirection, HomogeneousPoint) {
    check("a light with w = 2 or 0.5 is at its x, y and z divided by w",
          "(10.22) divides by w; (10.23) multiplies the surface's position by it.");
    expectDirection(sceneA, towards(sceneA, ahead, 2.2f, 2.0f));
    expectDirection(sceneB, towards(sceneB, beside, 0.9f, 0.5f));
}

TEST(LightDirection, OtherCamera) {
    check("a light keeps its place in the world when the camera moves",
          "Lights come in world coordinates: view takes them to the camera's.");
    const Scene moved{rigid(25.0f, {-0.6f, 0.4f, 0.7f}, {0.2f, 0.6f, -0.8f}), {0.2f, 0.5f, -2.8f}};
    expectDirection(moved, towards(moved, beside, 1.0f, 0.0f));
    expectDirection(moved, towards(moved, ahead, 2.0f, 1.0f));
}
