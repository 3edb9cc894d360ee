// Emission, E of (10.20): added once. Judged by the difference that it makes.
#include "truth.h"

using namespace judge;
using namespace truth;

namespace {

// What the colour gains when the material glows, for each trial.
void expectGlow(const std::string& what, std::vector<Trial> trials, const vec3& glow) {
    const std::size_t count = trials.size();
    for (std::size_t i = 0; i < count; ++i) {
        trials.push_back(trials[i]);
        trials.back().emision = glow;
    }
    const Colors got = shade(trials);
    for (std::size_t i = 0; i < count; ++i) {
        const dvec3 gained = got.at(count + i) - got.at(i);
        if (!close(gained, dvec3(glow)))
            fail(what + say(" emision {} adds {}, expected as much as it is", glow, vec3(gained)));
    }
}

Trial lit(int lights, const vec3& color) {
    Trial s = bench(Family::infinity, axisA, leaning(axisA, axisC, 30.0f),
                    leaning(axisA, axisB, 40.0f), color);
    s.ambient = {0.1f, 0.2f, 0.1f};
    s.diffuse = {0.5f, 0.4f, 0.6f};
    s.lights.resize(static_cast<std::size_t>(lights), s.lights[0]);
    return s;
}

}  // namespace

TEST(Emission, AddedOnce) {
    check("a lit surface that glows is brighter by its emission, once",
          "E stands in front of the sum of (10.20): not inside the loop, not twice.");
    expectGlow("on a surface under one light,", {lit(1, {0.8f, 0.8f, 0.8f})}, {0.3f, 0.5f, 0.2f});
    expectGlow("on a surface under three lights,", {lit(3, {0.2f, 0.3f, 0.2f})},
               {0.4f, 0.1f, 0.6f});
}

TEST(Emission, WithoutLights) {
    check("a surface glows in the dark, too");
    expectGlow("without any light,", {lit(0, vec3(1.0f))}, {0.5f, 0.25f, 0.7f});
}

TEST(Emission, NotColoured) {
    check("emission keeps its own colour under coloured light",
          "No light's colour and no other colour of the material multiplies E.");
    expectGlow("under a green light,", {lit(1, {0.1f, 0.9f, 0.2f})}, {0.6f, 0.3f, 0.5f});
    expectGlow("under a bright light,", {lit(1, {1.3f, 1.1f, 1.2f})}, {0.2f, 0.4f, 0.3f});
}
