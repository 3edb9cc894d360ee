// Many lights, the sum of (10.20): the colour under several lights is the sum of what the same
// shader shows under each of them alone.
#include <algorithm>

#include "truth.h"

using namespace judge;
using namespace truth;

namespace {

const std::vector<vec3> hues{{0.9f, 0.3f, 0.2f},
                             {0.2f, 0.8f, 0.5f},
                             {0.3f, 0.2f, 1.1f},
                             {0.7f, 0.6f, 0.1f},
                             {0.1f, 0.5f, 0.6f}};

// Lights at infinity about the normal axisA; the last of three is blue. Even ten of them stay below
// 1, where a shader that cuts off too early does no harm.
Trial under(std::size_t lights) {
    Trial s = bench(Family::infinity, axisA, leaning(axisA, axisC, 20.0f), axisA);
    s.ambient = {0.02f, 0.03f, 0.025f};
    s.diffuse = {0.12f, 0.1f, 0.14f};
    s.specular = {0.05f, 0.06f, 0.04f};
    s.shininess = 5.0f;
    s.lights.clear();
    for (std::size_t i = 0; i < lights; ++i) {
        const float turn = 0.7f * float(i);
        const vec3 aside = axisB * std::cos(turn) + axisC * std::sin(turn);
        const vec3 l = leaning(axisA, aside, 20.0f + 5.0f * float(i));
        s.lights.push_back(lamp(s, Family::infinity, {}, l, hues[i % hues.size()]));
    }
    return s;
}

void expectSum(const Trial& together) {
    std::vector<Trial> trials{together};
    for (const Lamp& each : together.lights) {
        trials.push_back(together);
        trials.back().lights = {each};
        trials.back().stale.clear();
    }
    const Colors got = shade(trials, loneOverlooked);
    dvec3 sum(0.0);
    for (std::size_t i = 1; i < got.size(); ++i)
        sum += got[i];
    const std::string what = say("{} lights", int(together.lights.size()));
    if (!expectThat(what + ", one at a time", std::max({sum.x, sum.y, sum.z}) > 0.05,
                    say("expected some light, got {} in all", vec3(sum))))
        return;
    if (!close(got[0], sum))
        fail(say("one at a time, the {} add up to {}; together they give {}", what, vec3(sum),
                 vec3(got[0])));
}

const std::vector<Lamp> leftovers{{{0.0f, 0.3f, 1.0f, 0.0f}, {0.5f, 0.9f, 0.8f}},
                                  {{0.4f, 0.1f, 0.2f, 1.0f}, {0.9f, 0.7f, 0.6f}},
                                  {{-0.6f, 0.5f, 0.8f, 0.0f}, {0.8f, 0.4f, 0.9f}}};

}  // namespace

TEST(ManyLights, ThreeColours) {
    check("three coloured lights add up",
          "Multiply each light's part by its own colour before adding it; never multiply the sum.");
    expectSum(under(3));
}

TEST(ManyLights, FiveAndTen) {
    check("five lights add up, and so do ten", "Count to nlights; there may be ten lights.");
    expectSum(under(5));
    expectSum(under(10));
}

TEST(ManyLights, OldSlots) {
    check("what the slots from nlights on still hold does not show",
          "Lights that were switched off stay in the arrays: stop at nlights.");
    Trial s = under(2);
    s.stale = leftovers;
    expectSum(s);
}

TEST(ManyLights, NoLight) {
    check("without lights the surface is black, with one it is not",
          "nlights may be 0: the first slot then means nothing.");
    Trial dark = under(0), lit = under(1);
    dark.stale = leftovers;
    const Colors got = shade({dark, lit});
    if (!close(got.at(0), dvec3(0.0)))
        fail(say("with nlights 0: expected (0, 0, 0), got {}", vec3(got.at(0))));
    const dvec3 one = got.at(1);
    expectThat("with nlights 1", std::max({one.x, one.y, one.z}) > 0.05,
               say("expected some light, got {}", vec3(one)));
}
