// The transformed unit normal, (7.41), read from n.l under three lights. view turns about each
// light in its turn, so the light's direction is the same in the world and for the camera.
// As long as the normal is right, a light that is turned by modelview, or one that is always taken
// for a point, costs nothing here; neither does a wrong diffuse part if n.h is right.
#include <algorithm>

#include "truth.h"

using namespace judge;
using namespace truth;

namespace {

const std::vector<vec3> lightsAhead{glm::normalize(vec3(0.35f, 0.1f, 0.9f)),
                                    glm::normalize(vec3(-0.3f, 0.25f, 0.9f)),
                                    glm::normalize(vec3(0.05f, -0.3f, 0.95f))};

// n is what the fragment's normal should become.
struct Surface {
    mat4 modelview;
    Fragment fragment;
    dvec3 n, v;
};

// A surface whose normal is n in camera coordinates and comes with this length.
Surface surface(const mat4& modelview, const vec3& n, float length = 1.0f) {
    const vec3 normal = glm::normalize(glm::transpose(glm::mat3(modelview)) * n);
    const Fragment fragment{{0.4f, -0.3f, 0.25f, 1.0f}, length * normal};
    const dvec3 p(modelview * fragment.position);
    return {modelview, fragment, glm::normalize(dvec3(n)), glm::normalize(-p)};
}

Trial under(const Surface& surface, Family family, const vec3& l) {
    Trial s;
    s.view = rigid(80.0f, l, {-0.6f, 0.3f, 0.5f});
    s.modelview = surface.modelview;
    s.fragments = {surface.fragment};
    s.diffuse = {1.0f, 0.0f, 0.0f};
    s.specular = {0.0f, 1.0f, 0.0f};
    s.shininess = 1.0f;
    s.lights = {lamp(s, family, vec3(s.modelview * surface.fragment.position), l, vec3(1.0f))};
    return s;
}

// Whether the colours under the three lights are those of the right normal, if l is as given.
bool agree(const Surface& surface, const dvec3* got, const std::vector<dvec3>& directions,
           bool highlight) {
    for (std::size_t j = 0; j < directions.size(); ++j) {
        const dvec3 l = directions[j];
        const dvec3 towards = highlight ? glm::normalize(surface.v + l) : l;
        const double expected = std::max(glm::dot(surface.n, towards), 0.0);
        const double found = highlight ? got[j].g : got[j].r;
        if (!(std::abs(found - expected) <= kTolerance))
            return false;
    }
    return true;
}

void expectNormal(const Surface& surface) {
    std::vector<Trial> trials;
    std::vector<dvec3> straight, turned;
    for (const Family family : {Family::infinity, Family::point})
        for (const vec3& l : lightsAhead)
            trials.push_back(under(surface, family, l));
    for (const vec3& l : lightsAhead) {
        straight.push_back(dvec3(l));
        turned.push_back(glm::normalize(glm::dmat3(surface.modelview) * dvec3(l)));
    }
    const Colors got = gains(trials, Slip(loneOverlooked | lightReversed));
    for (const bool highlight : {false, true})
        if (agree(surface, &got[0], straight, highlight) ||
            agree(surface, &got[0], turned, highlight) ||
            agree(surface, &got[3], straight, highlight))
            return;
    const glm::dmat3 rows = glm::transpose(glm::dmat3(straight[0], straight[1], straight[2]));
    const dvec3 n = glm::inverse(rows) * dvec3(got[0].r, got[1].r, got[2].r);
    fail(say("normal {} under modelview {}: expected {}, got {}", surface.fragment.normal,
             surface.modelview, vec3(surface.n), vec3(n)));
}

const mat4 turn = rigid(40.0f, {0.3f, 0.9f, -0.2f}, {0.3f, -0.5f, -3.2f});
const vec3 front = glm::normalize(vec3(0.25f, 0.2f, 0.95f));
const vec3 other = glm::normalize(vec3(-0.3f, -0.15f, 0.94f));

}  // namespace

TEST(Normals, Stretched) {
    check("on a stretched model the normal stays orthogonal to the surface",
          "Normals transform by the inverse transpose of the 3x3 block, (7.40).");
    const mat4 stretch = glm::scale(mat4(1.0f), {1.0f, 2.0f, 0.5f});
    expectNormal(surface(turn * stretch, front));
    expectNormal(surface(turn * stretch * rigid(30.0f, {0.5f, 0.1f, 0.7f}, vec3(0.0f)), other));
}

TEST(Normals, Sheared) {
    check("on a sheared model, too");
    mat4 shear(1.0f);
    shear[1] = {0.7f, 1.0f, 0.0f, 0.0f};
    shear[2] = {0.0f, -0.4f, 1.0f, 0.0f};
    expectNormal(surface(turn * shear, front));
    expectNormal(surface(turn * shear, other));
}

TEST(Normals, Turned) {
    check("the normal turns with the model", "n belongs in the same coordinates as l and v.");
    expectNormal(surface(turn, front));
    expectNormal(surface(rigid(-95.0f, {0.6f, 0.1f, 0.5f}, {0.2f, 0.7f, -2.5f}), other));
}

TEST(Normals, UnitLength) {
    check("the normal has length 1, whatever the length of the one that comes in",
          "Interpolation shortens normals, and so may modelview: normalise at the end.");
    expectNormal(surface(turn, front, 0.6f));
    expectNormal(surface(turn, other, 1.7f));
    expectNormal(surface(turn * glm::scale(mat4(1.0f), vec3(3.0f)), front));
}

TEST(Normals, FarAway) {
    check(
        "where the model stands does not bend its normals",
        "Only the 3x3 block of modelview acts on normals; with a vec4, drop w before normalising.");
    mat4 far = turn;
    far[3] = {6.0f, -4.0f, -15.0f, 1.0f};
    expectNormal(surface(far, front));
    expectNormal(surface(far * glm::scale(mat4(1.0f), {0.8f, 1.5f, 1.1f}), other));
}
