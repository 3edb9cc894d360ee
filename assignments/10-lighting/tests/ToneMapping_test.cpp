// Tone mapping, (10.2): each channel of the final sum becomes A L^gamma. Judged by what it does to
// the colour that the shader gives with A = 1 and gamma = 1. What is mapped is always below 1, so
// that it may be cut off there in the end; what comes before the mapping may be above.
#include <algorithm>

#include "truth.h"

using namespace judge;
using namespace truth;

namespace {

Trial bright(std::size_t lights, float scale) {
    Trial s = bench(Family::infinity, axisB, leaning(axisB, axisC, 25.0f),
                    leaning(axisB, axisA, 35.0f), scale * vec3(0.7f, 0.9f, 1.1f));
    s.ambient = {0.1f, 0.2f, 0.15f};
    s.diffuse = {0.5f, 0.3f, 0.6f};
    s.emision = {0.1f, 0.15f, 0.05f};
    s.lights.resize(lights, s.lights[0]);
    return s;
}

// `dimmer`: the colour before mapping is that of materials which reflect so much less, times this.
void expectMapped(const std::string& what, const Trial& bright, float exposure, float gamma,
                  float dimmer = 1.0f) {
    Trial plain = bright, mapped = bright;
    for (vec3* color : {&plain.ambient, &plain.diffuse, &plain.specular, &plain.emision})
        *color /= dimmer;
    mapped.exposure = exposure;
    mapped.gamma = gamma;
    const Colors got = shade({plain, mapped}, anySlip);
    const dvec3 base = double(dimmer) * got.at(0);
    if (!expectThat(what + ", the colour before mapping", std::min({base.x, base.y, base.z}) > 0.02,
                    say("expected some light in every channel, got {}", vec3(base))))
        return;
    const dvec3 expected = double(exposure) * glm::pow(base, dvec3(gamma));
    if (!close(got.at(1), expected))
        fail(what + say(": {} with exposure {} and gamma {}: expected {}, got {}", vec3(base),
                        exposure, gamma, vec3(expected), vec3(got.at(1))));
}

}  // namespace

TEST(ToneMapping, Gamma) {
    check("each channel is raised to the power gamma", "pow(L, gamma), not 1 / gamma.");
    expectMapped("under one light", bright(1, 1.0f), 1.0f, 0.45f);
    expectMapped("under one light", bright(1, 1.0f), 1.0f, 2.2f);
}

TEST(ToneMapping, Exposure) {
    check("exposure multiplies the power", "A stands outside the power in (10.2).");
    expectMapped("under one light", bright(1, 0.8f), 0.6f, 0.5f);
    expectMapped("under one light", bright(1, 0.8f), 1.4f, 1.0f);
}

TEST(ToneMapping, OnTheSum) {
    check("the sum of all lights and the emission is mapped, once",
          "Map after the loop; a sum of powers is not the power of the sum.");
    expectMapped("under three lights", bright(3, 0.35f), 0.9f, 0.5f);
}

TEST(ToneMapping, BeyondOne) {
    check("light above 1 is mapped before it is cut off", "Do not clamp before the mapping.");
    Trial s = bright(1, 5.0f);
    s.emision = vec3(0.0f);
    expectMapped("under a bright light", s, 0.4f, 0.45f, 8.0f);
}
