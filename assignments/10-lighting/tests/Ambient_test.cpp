// Ambient reflection, (10.4): C_ambient L for each light. Every surface here is turned away from
// its light, so that nothing else can show.
#include "truth.h"

using namespace judge;
using namespace truth;

namespace {

// Seen along v, lit from behind: n.l < 0 < n.h < 0.9.
Trial behind(Family family, const vec3& axis, const vec3& towards, const vec3& ambient,
             const vec3& color) {
    Trial s =
        bench(family, axis, leaning(axis, towards, 30.0f), leaning(axis, towards, 105.0f), color);
    s.ambient = ambient;
    s.shininess = 60.0f;
    return s;
}

}  // namespace

TEST(Ambient, TimesTheLight) {
    check("the ambient part is C_ambient times the light's colour, channel by channel");
    expectEitherFamily("the ambient part", [](Family family) {
        return std::vector{
            behind(family, axisA, axisB, {0.4f, 0.7f, 0.2f}, {0.9f, 0.5f, 1.4f}),
            behind(family, axisB, axisC, {0.8f, 0.1f, 0.5f}, {0.3f, 1.2f, 0.7f}),
        };
    });
}

TEST(Ambient, WhereverTheSurface) {
    check("the ambient part is the same on a lit surface and on one that faces away",
          "No n.l, no n.h and no distance in the ambient part.");
    expectEitherFamily("the ambient part", [](Family family) {
        std::vector<Trial> trials;
        for (const float degrees : {10.0f, 50.0f, 110.0f}) {
            Trial s = bench(family, axisC, leaning(axisC, axisA, 25.0f),
                            leaning(axisC, axisA, degrees), {0.6f, 0.9f, 0.4f});
            s.ambient = {0.5f, 0.3f, 0.8f};
            trials.push_back(s);
        }
        return trials;
    });
}

TEST(Ambient, NotAttenuated) {
    check("the ambient part does not get weaker with the distance",
          "f(d) belongs to the diffuse and specular parts only, (10.20).");
    std::vector<Trial> trials;
    for (const vec3& axis : axes) {
        Trial s = behind(Family::point, axis, {0.3f, -0.5f, 0.7f}, {0.6f, 0.8f, 0.4f},
                         {0.9f, 0.5f, 1.1f});
        s.attenuation = {1.5f, 0.4f, 0.2f};
        trials.push_back(s);
    }
    expectOneFamily("with attenuation (1.5, 0.4, 0.2), the ambient part",
                    {{Family::point, trials}});
}

TEST(Ambient, EachLight) {
    check("each light has an ambient part of its own",
          "The ambient part stands inside the sum of (10.20).");
    // A red and a green light: where the directed parts show both, the ambient part must, too.
    Trial lit = bench(Family::infinity, axisA, leaning(axisA, axisB, 20.0f), axisA, {1, 0, 0});
    lit.lights.push_back({lit.lights[0].position, {0, 1, 0}});
    Trial directed = lit;
    directed.diffuse = directed.specular = {0.8f, 0.8f, 0.8f};
    lit.ambient = {0.6f, 0.7f, 0.5f};
    const Colors got = gains({lit, directed});
    const auto shows = [](double channel) { return channel > 0.02; };
    expectThat("the ambient parts of two lights", shows(got[0].r) || shows(got[0].g),
               say("got {}", vec3(got[0])));
    if ((shows(got[1].r) && !shows(got[0].r)) || (shows(got[1].g) && !shows(got[0].g)))
        fail(say(
            "under a red and a green light the ambient part is {}, while the other parts are {}",
            vec3(got[0]), vec3(got[1])));
}
