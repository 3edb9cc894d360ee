// Attenuation, f(d) of (10.14): how much less light there is with attenuation than with (1, 0, 0),
// read off the diffuse and the specular part of the same surface. All lights are points.
#include "truth.h"

using namespace judge;
using namespace truth;

namespace {

const vec3 p(0.5f, -0.3f, -3.5f);
const vec3 direction = glm::normalize(vec3(0.2f, 0.3f, 0.9f));

// Six normals all round: some of them see the light, whatever the shader takes for its direction.
Trial lit(float distance, float w, const vec3& color = vec3(1.0f)) {
    Trial s;
    s.view = rigid(70.0f, {0.5f, -0.8f, 0.3f}, {0.5f, -0.4f, -1.2f});
    s.modelview = rigid(-40.0f, {0.1f, 0.7f, 0.6f}, {-0.4f, 0.2f, -2.0f});
    s.diffuse = {0.9f, 0.0f, 0.0f};
    s.specular = {0.0f, 0.9f, 0.0f};
    s.shininess = 2.0f;
    for (const vec3& axis : axes) {
        addFragment(s, p, axis);
        addFragment(s, p, -axis);
    }
    s.lights = {{w * lamp(s, Family::point, p, direction, color, distance).position, color}};
    return s;
}

// How many of the values that show any light were compared; wrong ones fail the check.
void expectShare(const std::string& what, const Trial& plain, const vec3& c, double share) {
    Trial weaker = plain;
    weaker.attenuation = c;
    const Colors got = shade({plain, weaker}, loneOverlooked);
    const std::size_t count = plain.fragments.size();
    bool any = false;
    for (std::size_t i = 0; i < count; ++i)
        for (glm::length_t channel = 0; channel < 2; ++channel) {
            const double before = got.at(i)[channel], after = got.at(count + i)[channel];
            if (!(before > 0.1))  // no light there, or no number
                continue;
            any = true;
            if (!(std::abs(after / before - share) <= kTolerance)) {
                fail(what + say(", attenuation {}: expected {} times the {} part, got {} times", c,
                                float(share), channel == 0 ? "diffuse" : "specular",
                                float(after / before)));
                return;
            }
        }
    expectThat(what + ", without attenuation", any, "no light was seen");
}

void expectLeft(float distance, float w, const vec3& c) {
    expectShare(say("a light at distance {}, w = {}", distance, w), lit(distance, w), c,
                left(c, double(distance)));
}

}  // namespace

TEST(Attenuation, Formula) {
    check(
        "light gets weaker with its distance: 1 / (c0 + c1 d + c2 d^2)",
        "attenuation holds c0, c1, c2. d is measured between two points in the same coordinates.");
    expectLeft(1.5f, 1.0f, {1.0f, 0.4f, 0.15f});
    expectLeft(3.0f, 1.0f, {0.6f, 0.2f, 0.5f});
}

TEST(Attenuation, NeverMore) {
    check("light never gets stronger: near a lamp f(d) stays at 1", "min(..., 1), (10.14).");
    expectLeft(0.5f, 1.0f, {0.3f, 0.2f, 0.1f});
    expectLeft(6.0f, 1.0f, {0.3f, 0.2f, 0.1f});
}

TEST(Attenuation, HomogeneousPoint) {
    check("the distance to a light with w = 2 or 0.5 is that to its x, y, z divided by w",
          "The vector of (10.23) before normalising is w times too long.");
    expectLeft(1.2f, 2.0f, {1.0f, 0.5f, 0.3f});
    expectLeft(2.6f, 0.5f, {0.5f, 0.3f, 0.2f});
}
