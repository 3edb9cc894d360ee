// Diffuse reflection, (10.14): C_diffuse max(n.l, 0) L.
#include "truth.h"

using namespace judge;
using namespace truth;

namespace {

// Lit along l with the camera off to a side. shininess is high, so a highlight of a wrong colour
// would not show.
Trial matt(Family family, const vec3& axis, float lightDegrees, float viewDegrees = 35.0f) {
    const vec3 aside(0.2f, 0.9f, -0.4f), l = leaning(axis, aside, lightDegrees);
    const vec3 v = leaning(axis, glm::cross(axis, aside), viewDegrees);
    Trial s = bench(family, axis, v, l);
    s.diffuse = vec3(0.8f);
    s.shininess = 60.0f;
    return s;
}

}  // namespace

TEST(Diffuse, CosineLaw) {
    check("the diffuse part falls off with the cosine between normal and light",
          "n.l with both of length 1; l points from the surface to the light.");
    expectEitherFamily("the diffuse part", [](Family family) {
        return std::vector{matt(family, axisA, 15.0f), matt(family, axisB, 40.0f),
                           matt(family, axisC, 65.0f), matt(family, axisA, 80.0f)};
    });
}

TEST(Diffuse, FacingAway) {
    check("a surface that faces away from the light gets no diffuse light, and loses none",
          "max(n.l, 0), (10.13): without it, light behind a surface darkens it.");
    expectEitherFamily("the diffuse part", [](Family family) {
        return std::vector{matt(family, axisC, 30.0f), matt(family, axisA, 110.0f),
                           matt(family, axisB, 135.0f)};
    });
}

TEST(Diffuse, ColourTimesColour) {
    check("the diffuse part is C_diffuse times the light's colour, channel by channel");
    expectEitherFamily("the diffuse part", [](Family family) {
        std::vector<Trial> trials{matt(family, axisB, 25.0f), matt(family, axisC, 50.0f)};
        trials[0].diffuse = {0.9f, 0.4f, 0.15f};
        trials[0].lights[0].color = {0.5f, 1.3f, 0.8f};
        trials[1].diffuse = {0.2f, 0.6f, 1.0f};
        trials[1].lights[0].color = {1.6f, 0.3f, 0.7f};
        return trials;
    });
}

TEST(Diffuse, FromAnySide) {
    check("the diffuse part looks the same from every side",
          "Diffuse light goes out evenly: v has no place in (10.14).");
    expectEitherFamily("the diffuse part", [](Family family) {
        return std::vector{matt(family, axisA, 45.0f, 20.0f), matt(family, axisA, 45.0f, 50.0f),
                           matt(family, axisA, 45.0f, -40.0f)};
    });
}
