// Slips of one region that turn or hide the light of all others: a direction or a normal of the
// wrong sign, a loop that is one short and so never sees a light that is alone. They are looked for
// first. What is asked about the other tasks is then put so that the slip does not show there:
// light and normal turned once more, the light between two black ones. Only the harness includes
// this file; it asks the student's shader for a few colours.
#pragma once

#include <cg/ShaderProbe.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene.h"

namespace course {

struct Habits {
    bool overlooksLone = false;   ///< a light that is alone does not show, between others it does
    bool lightReversed = false;   ///< l points from the light to the surface
    bool normalReversed = false;  ///< n points into the surface
};

/// Black, and with a direction that can be normalised.
inline Light blackLight() {
    return light({0.6f, 0.64f, 0.48f, 0.0f}, glm::vec3(0.0f));
}

class HabitProbe {
public:
    /// What the shader shows, with a context current.
    static Habits look() {
        Habits habits;
        bool plain = false;
        for (const float w : {0.0f, 1.0f}) {  // a slip with the other kind of light does no harm
            Shown shown = ask(w, false);
            if (!anyLight(shown)) {
                shown = ask(w, true);
                habits.overlooksLone = habits.overlooksLone || anyLight(shown);
            }
            judge(shown, habits, plain);
        }
        if (plain) {
            habits.lightReversed = habits.normalReversed = false;
        }
        return habits;
    }

private:
    enum Side { right, lightTurned, normalTurned, bothTurned };
    using Shown = std::array<glm::vec3, 4>;  // diffuse red, specular green, ambient blue

    // One surface, lit along its normal and seen from a side. view and modelview turn about that
    // normal, so that a slip with the coordinates does not show.
    static Shown ask(float w, bool betweenOthers) {
        const glm::vec3 n = glm::normalize(glm::vec3(0.32f, 0.48f, 0.82f));
        const glm::vec3 aside = glm::normalize(glm::cross(n, glm::vec3(0.2f, 0.9f, -0.4f)));
        const glm::vec3 v = 0.766f * n + 0.643f * aside, p = -4.0f * v;
        const auto turned = [&n](float degrees, const glm::vec3& shift) {
            return glm::rotate(glm::translate(glm::mat4(1.0f), shift), glm::radians(degrees), n);
        };
        const glm::mat4 view = turned(65.0f, {0.4f, -0.9f, -1.3f});
        const glm::mat4 modelview = turned(-50.0f, glm::vec3(0.0f));
        const glm::vec4 place = glm::inverse(modelview) * glm::vec4(p, 1.0f);

        Shown shown;
        for (const Side side : {right, lightTurned, normalTurned, bothTurned}) {
            const bool turnLight = side == lightTurned || side == bothTurned;
            const bool turnNormal = side == normalTurned || side == bothTurned;
            const glm::vec3 l = turnLight ? -n : n;
            const glm::vec3 seen = w == 0.0f ? l : p + 2.5f * l;
            const Light lamp = light(
                glm::vec4(glm::vec3(glm::inverse(view) * glm::vec4(seen, w)), w), glm::vec3(1.0f));
            std::vector<Light> lights{lamp};
            if (betweenOthers) {
                lights = {blackLight(), lamp, blackLight()};
            }
            cg::Uniforms uniforms;
            uniforms.ints = {{"nlights", int(lights.size())}, {"enablelighting", 1}};
            lights.resize(10, blackLight());
            for (const Light& each : lights) {
                uniforms.vec4Arrays["lightpositions"].push_back(each.position);
                uniforms.vec4Arrays["lightcolors"].push_back(each.color);
            }
            uniforms.mat4s = {{"view", view}, {"modelview", modelview}};
            uniforms.vec4s = {{"ambient", {0.0f, 0.0f, 0.5f, 1.0f}},
                              {"diffuse", {0.8f, 0.0f, 0.0f, 1.0f}},
                              {"specular", {0.0f, 0.8f, 0.0f, 1.0f}},
                              {"emision", {0.0f, 0.0f, 0.0f, 1.0f}}};
            uniforms.floats = {{"shininess", 1.0f}, {"exposure", 1.0f}, {"gamma", 1.0f}};
            uniforms.vec3s = {{"attenuation", {1.0f, 0.0f, 0.0f}}};
            const glm::vec4 normal(turnNormal ? -n : n, 0.0f);
            shown[side] = glm::vec3(cg::probeFragment("shaders/lighting.frag",
                                                      {{"position", {place}}, {"normal", {normal}}},
                                                      uniforms)[0]);
        }
        return shown;
    }

    static bool anyLight(const Shown& shown) {
        return std::any_of(shown.begin(), shown.end(), [](const glm::vec3& color) {
            return !(std::max({std::abs(color.r), std::abs(color.g), std::abs(color.b)}) < 0.01f);
        });
    }

    // A sign is wrong when both parts say so: where one of them alone does, the slip is in that
    // part. The diffuse part cannot tell which sign it is, the specular part can; where there is
    // none, it is taken to be the light's.
    static void judge(const Shown& shown, Habits& habits, bool& plain) {
        constexpr float margin = 0.1f;
        const auto diffuse = [&](Side side) { return shown[side].r; };
        const auto specular = [&](Side side) { return shown[side].g; };
        plain = plain || diffuse(right) > diffuse(lightTurned) + margin;
        if (!(diffuse(lightTurned) > diffuse(right) + margin)) {
            return;
        }
        const float asIs = std::max(specular(right), specular(normalTurned));
        const float turned = std::max(specular(lightTurned), specular(bothTurned));
        const bool none = std::max(std::abs(asIs), std::abs(turned)) < margin;
        if (none || turned > asIs + margin) {
            habits.lightReversed = true;
        } else if (specular(normalTurned) > specular(right) - margin) {
            habits.normalReversed = true;
        }
    }
};

}  // namespace course
