// Blinn-Phong reflection, (10.19): C_specular max(n.h, 0)^shininess L. In each trial two of n, v
// and l agree, so that turning the world about them changes nothing.
#include "truth.h"

using namespace judge;
using namespace truth;

namespace {

const vec3 aside(0.7f, -0.3f, 0.2f);

// Seen straight on: v = n.
Trial straightOn(Family family, const vec3& axis, float lightDegrees, float shininess) {
    Trial s = bench(family, axis, axis, leaning(axis, aside, lightDegrees));
    s.specular = vec3(0.9f);
    s.shininess = shininess;
    return s;
}

// Lit straight on: l = n.
Trial litStraightOn(Family family, const vec3& axis, float viewDegrees, float shininess) {
    Trial s = bench(family, axis, leaning(axis, aside, viewDegrees), axis, vec3(1.0f),
                    {-0.7f, 0.6f, -3.1f});
    s.specular = vec3(0.9f);
    s.shininess = shininess;
    return s;
}

// Lit, but turned away from the camera, as interpolated normals can be. It glows.
Trial turnedAway(Family family, const vec3& axis) {
    const vec3 v = leaning(axis, aside, 30.0f), l = leaning(-axis, aside, 65.0f);
    Trial s = bench(family, -axis, v, l);
    s.specular = vec3(0.9f);
    s.shininess = 2.0f;
    s.emision = {0.3f, 0.4f, 0.2f};
    return s;
}

}  // namespace

TEST(Specular, HalfwayVector) {
    check("a surface seen straight on shines by its half vector",
          "h = normalize(v + l), (10.17). With the reflected ray (10.15) in its place the same "
          "exponent gives a smaller highlight.");
    expectEitherFamily("the specular part", [](Family family) {
        return std::vector{straightOn(family, axisA, 20.0f, 10.0f),
                           straightOn(family, axisB, 45.0f, 5.0f),
                           straightOn(family, axisC, 70.0f, 7.0f)};
    });
}

TEST(Specular, FromTheSurfaceToTheEye) {
    check("v points from the surface to the camera, wherever on the picture the surface is",
          "In camera coordinates the camera is the origin: v = normalize(-p), with p = modelview * "
          "position.");
    expectEitherFamily("the specular part", [](Family family) {
        return std::vector{litStraightOn(family, axisC, 25.0f, 10.0f),
                           litStraightOn(family, axisA, 45.0f, 5.0f),
                           litStraightOn(family, axisB, 60.0f, 4.0f)};
    });
}

TEST(Specular, Shininess) {
    check("the exponent is the material's shininess");
    expectEitherFamily("the specular part", [](Family family) {
        std::vector<Trial> trials;
        for (const float shininess : {2.0f, 12.0f, 30.0f})
            trials.push_back(straightOn(family, axisB, 40.0f, shininess));
        return trials;
    });
}

TEST(Specular, NoHighlightBehind) {
    check("where n.h is negative there is no highlight",
          "max(n.h, 0) before pow: the power of a negative number is undefined in GLSL.");
    // Next to a glow, since a number that is undefined may well be shown as black. It must look
    // like the glow alone: a material without specular colour, turned towards camera and light, so
    // that nothing is undefined there.
    const auto undisturbed = [](Family family) {
        std::vector<Trial> trials;
        for (const vec3& axis : axes) {
            trials.push_back(turnedAway(family, axis));
            Trial glow = trials.back();
            glow.specular = vec3(0.0f);
            glow.fragments[0].normal = -glow.fragments[0].normal;
            trials.push_back(glow);
        }
        const Colors got = shade(trials, anySlip);
        for (std::size_t i = 0; i < got.size(); i += 2)
            if (!close(got[i], got[i + 1]))
                return say("expected {} where n.h is negative, as from the glow alone, got {}",
                           vec3(got[i + 1]), vec3(got[i]));
        return std::string();
    };
    const std::string complaint = undisturbed(Family::infinity);
    if (!complaint.empty() && !undisturbed(Family::point).empty())
        fail(complaint);
    expectEitherFamily("the specular part", [](Family family) {
        return std::vector{straightOn(family, axisA, 35.0f, 6.0f)};
    });
}

TEST(Specular, ColourTimesColour) {
    check("the specular part is C_specular times the light's colour, channel by channel");
    expectEitherFamily("the specular part", [](Family family) {
        std::vector<Trial> trials{straightOn(family, axisC, 30.0f, 4.0f),
                                  litStraightOn(family, axisB, 35.0f, 6.0f)};
        trials[0].specular = {0.9f, 0.5f, 0.3f};
        trials[0].lights[0].color = {0.6f, 1.4f, 0.8f};
        trials[1].specular = {0.2f, 0.7f, 1.0f};
        trials[1].lights[0].color = {1.5f, 0.4f, 0.9f};
        return trials;
    });
}
