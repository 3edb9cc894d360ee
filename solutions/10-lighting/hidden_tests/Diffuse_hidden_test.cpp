#include "truth.h"

using namespace judge;
using namespace truth;

TEST(Diffuse, DrawnSurfaces) {
    check("six matt surfaces drawn from the seed have the right colour");
    std::vector<Trial> infinite, near;
    for (int i = 0; i < 6; ++i) {
        const vec3 axis = axes[static_cast<std::size_t>(i) % axes.size()];
        const vec3 l =
            leaning(axis, judge::random().unitVector(), judge::random().uniform(10, 130));
        const vec3 v = leaning(axis, judge::random().unitVector(), judge::random().uniform(20, 45));
        const vec3 color = vec3(0.55f) + 0.4f * judge::random().unitVector();
        const vec3 material = vec3(0.5f) + 0.4f * judge::random().unitVector();
        for (const Family family : {Family::infinity, Family::point}) {
            Trial trial = bench(family, axis, v, l, color);
            trial.diffuse = material;
            trial.shininess = 60.0f;
            (family == Family::infinity ? infinite : near).push_back(trial);
        }
    }
    expectOneFamily("the diffuse part", {{Family::infinity, infinite}, {Family::point, near}});
}
