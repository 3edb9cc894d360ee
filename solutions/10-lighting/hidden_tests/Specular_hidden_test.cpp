#include "truth.h"

using namespace judge;
using namespace truth;

TEST(Specular, DrawnSurfaces) {
    check("six shiny surfaces drawn from the seed have the right colour");
    std::vector<Trial> infinite, near;
    for (int i = 0; i < 6; ++i) {
        const vec3 axis = axes[static_cast<std::size_t>(i) % axes.size()];
        const vec3 other =
            leaning(axis, judge::random().unitVector(), judge::random().uniform(20, 60));
        const vec3 color = vec3(0.6f) + 0.4f * judge::random().unitVector();
        const float shininess = judge::random().uniform(3.0f, 12.0f);
        for (const Family family : {Family::infinity, Family::point}) {
            Trial trial = i % 2 == 0 ? bench(family, axis, axis, other, color)
                                     : bench(family, axis, other, axis, color);
            trial.specular = {0.9f, 0.6f, 0.4f};
            trial.shininess = shininess;
            (family == Family::infinity ? infinite : near).push_back(trial);
        }
    }
    expectOneFamily("the specular part", {{Family::infinity, infinite}, {Family::point, near}});
}
