// Two of the four edges turn the leg, which is square, by 90 degrees, and one mirrors it. In the
// models the move stands on the right of the scaling, S T: it is measured in cubes.
#include "Table.h"

#include <array>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace glm;

void buildTable(Node& table, Node& top, Node& leg, Model* piece, const vec3& size,
                float thickness) {
    const mat4 I(1.0f);

    // The cube's lower side is lifted to 0 first, then stretched.
    const vec3 postExtent(thickness, size.y - thickness, thickness);
    leg.models.resize(1, piece);
    leg.modeltransforms.resize(1, translate(scale(I, postExtent), vec3(0, 0.5, 0)));

    // The same upside down for the top: its upper side at 0.
    const vec3 boardExtent(size.x, thickness, size.z);
    top.models.resize(1, piece);
    top.modeltransforms.resize(1, translate(scale(I, boardExtent), vec3(0, -0.5, 0)));

    const float x = 0.5f * (size.x - thickness);
    const float z = 0.5f * (size.z - thickness);
    const std::array<mat4, 4> places = {
        translate(I, vec3(x, 0, z)),
        rotate(translate(I, vec3(-x, 0, z)), half_pi<float>(), vec3(0, 1, 0)),
        scale(translate(I, vec3(-x, 0, -z)), vec3(-1, 1, 1)),
        rotate(translate(I, vec3(x, 0, -z)), -half_pi<float>(), vec3(0, 1, 0)),
    };
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(translate(I, vec3(0, size.y, 0)));
    for (const mat4& place : places) {
        table.childnodes.push_back(&leg);
        table.childtransforms.push_back(place);
    }
}
