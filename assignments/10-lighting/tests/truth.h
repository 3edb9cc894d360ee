// The right colour of a fragment by (10.14), (10.19) and (10.20), in double precision, and the
// trials that the tests share.
//
// A trial is one set of uniforms with the fragments that are shaded under it. Most are made so that
// a mistake in one task leaves the others' numbers as they are:
//  - where normals and lights are not the matter, view and modelview turn about the normal, so its
//    components are the same in the model, in the world and for the camera;
//  - such checks are made with lights at infinity and again with lights at w = 1; one of the two
//    being right is enough, since the difference belongs to light-direction;
//  - a direction or a normal of the wrong sign, and a loop that misses a light that is alone, are
//    looked for first, and the trials of the other tasks are put so that it does not show (Slip).
#pragma once

#include <subject/Judge.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <string>
#include <vector>

namespace truth {

using glm::dvec3;
using glm::dvec4;
using glm::mat4;
using glm::vec3;
using glm::vec4;
using Colors = std::vector<dvec3>;

struct Lamp {
    vec4 position;  ///< world coordinates
    vec3 color;
};

struct Fragment {
    vec4 position;  ///< model coordinates, w = 1
    vec3 normal;    ///< model coordinates
};

struct Trial {
    mat4 view{1}, modelview{1};
    vec3 ambient{0}, diffuse{0}, specular{0}, emision{0};
    float shininess = 10.0f;
    std::vector<Lamp> lights;
    std::vector<Lamp> stale;  ///< what the slots beyond `lights` hold; else they are black
    vec3 attenuation{1, 0, 0};
    float exposure = 1.0f, gamma = 1.0f;
    std::vector<Fragment> fragments;
};

// ---- Asking the student's shader
// -----------------------------------------------------------------

/// Slips of one region that turn or hide the light of all others (habits.h). The harness makes up
/// for those that it is told, where the shader has them: lights on the other side of a trial's
/// first fragment, normals turned round, a light that is alone between two black ones.
enum Slip { noSlip = 0, loneOverlooked = 1, lightReversed = 2, normalReversed = 4, anySlip = 7 };

/// Colours of all fragments of all trials, one after the other; alpha is the student's own affair.
/// Always as many as there are fragments: a colour that did not come is no number.
inline Colors shade(const std::vector<Trial>& trials, Slip madeUpFor = noSlip) {
    std::vector<int> counts;
    std::vector<vec4> positions, normals, values, lights;
    std::vector<mat4> matrices;
    for (const Trial& s : trials) {
        counts.push_back(static_cast<int>(s.fragments.size()));
        for (const Fragment& f : s.fragments) {
            positions.push_back(f.position);
            normals.push_back(vec4(f.normal, 0.0f));
        }
        matrices.insert(matrices.end(), {s.view, s.modelview});
        for (const vec3& color : {s.ambient, s.diffuse, s.specular, s.emision})
            values.push_back(vec4(color, 1.0f));
        values.push_back({s.shininess, s.exposure, s.gamma, float(s.lights.size())});
        values.push_back(vec4(s.attenuation, 0.0f));
        std::vector<Lamp> slots = s.lights;
        slots.insert(slots.end(), s.stale.begin(), s.stale.end());
        slots.resize(10, {{0.6f, 0.64f, 0.48f, 0.0f}, vec3(0.0f)});
        for (const Lamp& lamp : slots)
            lights.push_back(lamp.position);
        for (const Lamp& lamp : slots)
            lights.push_back(vec4(lamp.color, 1.0f));
    }
    Colors colors;
    std::vector<double> seen;
    const std::size_t asked = positions.size();
    for (const vec4& color :
         judge::subject().shade<std::vector<vec4>>("lighting", static_cast<int>(madeUpFor), counts,
                                                   positions, normals, matrices, values, lights)) {
        colors.push_back(dvec3(color));
        seen.insert(seen.end(), {color.r, color.g, color.b});
    }
    judge::observed("list", seen);
    colors.resize(asked, dvec3(std::numeric_limits<double>::quiet_NaN()));
    return colors;
}

// ---- The right answer
// ----------------------------------------------------------------------------

/// n, v and l of one fragment and one light, in camera coordinates; d is -1 for a light at
/// infinity.
struct Geometry {
    dvec3 n, v, l;
    double d;
};
inline Geometry geometry(const Trial& s, const Fragment& f, const Lamp& lamp) {
    const glm::dmat4 view(s.view), modelview(s.modelview);
    const dvec4 p = modelview * dvec4(f.position), light = view * dvec4(lamp.position);
    const dvec3 n = glm::transpose(glm::inverse(glm::dmat3(modelview))) * dvec3(f.normal);
    const dvec3 towards = p.w * dvec3(light) - light.w * dvec3(p);
    const double d = light.w == 0.0 ? -1.0 : glm::length(towards) / (p.w * light.w);
    return {glm::normalize(n), glm::normalize(-dvec3(p)), glm::normalize(towards), d};
}

/// f(d) of (10.14).
inline double left(const vec3& c, double d) {
    return d < 0.0 ? 1.0
                   : std::min(1.0 / (double(c.x) + double(c.y) * d + double(c.z) * d * d), 1.0);
}

inline dvec3 right(const Trial& s, const Fragment& f) {
    dvec3 sum(s.emision);
    for (const Lamp& lamp : s.lights) {
        const auto [n, v, l, d] = geometry(s, f, lamp);
        const dvec3 h = glm::normalize(v + l);
        const double highlight = std::pow(std::max(glm::dot(n, h), 0.0), double(s.shininess));
        const dvec3 directed =
            dvec3(s.diffuse) * std::max(glm::dot(n, l), 0.0) + dvec3(s.specular) * highlight;
        sum += (dvec3(s.ambient) + left(s.attenuation, d) * directed) * dvec3(lamp.color);
    }
    return double(s.exposure) * glm::pow(sum, dvec3(s.gamma));
}

// ---- Making trials
// -------------------------------------------------------------------------------

enum class Family { infinity, point };
inline const char* name(Family family) {
    return family == Family::infinity ? "a light at infinity" : "a light with w = 1";
}

/// A rigid map: a turn about `axis`, then a shift.
inline mat4 rigid(float degrees, const vec3& axis, const vec3& shift) {
    return glm::rotate(glm::translate(mat4(1.0f), shift), glm::radians(degrees),
                       glm::normalize(axis));
}

/// `from` turned by `degrees` towards `to` (or away from it, if negative); all of length 1.
inline vec3 leaning(const vec3& from, const vec3& to, float degrees) {
    const vec3 side = glm::normalize(to - glm::dot(to, from) * from);
    return std::cos(glm::radians(degrees)) * from + std::sin(glm::radians(degrees)) * side;
}

/// Adds a fragment that lies at p with the unit normal n in camera coordinates.
inline void addFragment(Trial& s, const vec3& p, const vec3& n) {
    const vec3 normal = glm::transpose(glm::mat3(s.modelview)) * n;
    const vec3 place(glm::inverse(s.modelview) * vec4(p, 1.0f));
    s.fragments.push_back({vec4(place, 1.0f), glm::normalize(normal)});
}

/// Camera coordinates (x, y, z, w) in the world, with exactly this w.
inline vec4 inWorld(const mat4& view, const vec3& xyz, float w) {
    return vec4(vec3(glm::inverse(view) * vec4(xyz, w)), w);
}

/// A light that is seen from p in the direction l (camera coordinates), `distance` away if near.
inline Lamp lamp(const Trial& s, Family family, const vec3& p, const vec3& l, const vec3& color,
                 float distance = 2.5f) {
    return {inWorld(s.view, family == Family::infinity ? l : p + distance * l,
                    family == Family::infinity ? 0.0f : 1.0f),
            color};
}

/// One fragment with unit normal n, seen along v and lit along l (camera coordinates), 4 units away
/// from the camera. view and modelview turn about n; the model's origin is at `shift`, as a rule in
/// the camera itself, so that a normal that picks up the model's place is wrong elsewhere.
inline Trial bench(Family family, const vec3& n, const vec3& v, const vec3& l,
                   const vec3& color = vec3(1.0f), const vec3& shift = vec3(0.0f)) {
    Trial s;
    s.view = rigid(65.0f, n, {0.4f, -0.9f, -1.3f});
    s.modelview = rigid(-50.0f, n, shift);
    const vec3 p = -4.0f * v;
    addFragment(s, p, n);
    s.lights = {lamp(s, family, p, l, color)};
    return s;
}

/// Unit vectors in general position, all of them looking towards the camera.
inline const vec3 axisA = glm::normalize(vec3(0.32f, 0.48f, 0.82f));
inline const vec3 axisB = glm::normalize(vec3(-0.55f, 0.21f, 0.81f));
inline const vec3 axisC = glm::normalize(vec3(0.4f, -0.63f, 0.66f));
inline const std::vector<vec3> axes{axisA, axisB, axisC};

// ---- Comparing
// -----------------------------------------------------------------------------------

constexpr double kTolerance = 2e-3;  // of max(1, |expected|): llvmpipe's pow is good to about 1e-4

inline bool close(const dvec3& got, const dvec3& expected, double tolerance = kTolerance) {
    const auto largest = [](const dvec3& v) {
        const dvec3 a = glm::abs(v);
        return std::max({a.x, a.y, a.z});
    };
    const dvec3 difference = got - expected;
    for (glm::length_t i = 0; i < 3; ++i)
        if (!std::isfinite(difference[i]))
            return false;
    return largest(difference) <= tolerance * std::max(1.0, largest(expected));
}

/// "n.l = 0.5, n.h = 0.9, material (…), light (…)": what a student needs to redo the sum.
inline std::string tell(const Trial& s) {
    const auto [n, v, l, d] = geometry(s, s.fragments.at(0), s.lights.at(0));
    const auto h = glm::normalize(v + l);
    return judge::say("n.l = {}, n.h = {}, light colour {}", float(glm::dot(n, l)),
                      float(glm::dot(n, h)), s.lights[0].color);
}

/// Trials of one family that must all be right, each with one fragment.
struct Cases {
    Family family;
    std::vector<Trial> trials;
};

/// What the material's colours add to the picture: the colours less those of the same trials with
/// a black material. So a part that is there whatever its material costs its own task alone.
inline Colors gains(const std::vector<Trial>& trials, Slip madeUpFor = anySlip) {
    std::vector<Trial> both = trials;
    for (Trial black : trials) {
        black.ambient = black.diffuse = black.specular = vec3(0.0f);
        both.push_back(black);
    }
    const Colors got = shade(both, madeUpFor);
    Colors gained;
    for (std::size_t i = 0; i < got.size() / 2; ++i)
        gained.push_back(got[i] - got[got.size() / 2 + i]);
    return gained;
}

/// Passes when all trials of one family are right. Else tells the first wrong one of the family
/// that came closer.
inline void expectOneFamily(const std::string& what, const std::vector<Cases>& families) {
    std::vector<Trial> all;
    for (const Cases& cases : families)
        all.insert(all.end(), cases.trials.begin(), cases.trials.end());
    const Colors got = gains(all);
    std::size_t next = 0, fewest = all.size() + 1;
    std::string complaint;
    for (const Cases& cases : families) {
        std::size_t wrong = 0;
        std::string first;
        for (const Trial& s : cases.trials) {
            const dvec3 color = got.at(next++), expected = right(s, s.fragments[0]);
            if (!close(color, expected) && wrong++ == 0)
                first = what + judge::say(" under {} (", name(cases.family)) + tell(s) +
                        judge::say("): expected {}, got {}", vec3(expected), vec3(color));
        }
        if (wrong < fewest) {
            fewest = wrong;
            complaint = first;
        }
    }
    if (fewest > 0)
        judge::fail(complaint);
}

/// The same cases for both families.
template <class Make>
void expectEitherFamily(const std::string& what, Make make) {
    expectOneFamily(
        what, {{Family::infinity, make(Family::infinity)}, {Family::point, make(Family::point)}});
}

}  // namespace truth
