// A helper lambda makes a box from two opposite corners. Top and leg lie in the table's coordinates
// already, so the edge to the top is the identity, and the edges to the leg move the first leg to
// the other corners.
#include "Table.h"

#include <cg/Todo.h>

#include <glm/gtc/matrix_transform.hpp>

void buildTable(Node& table, Node& top, Node& leg, Model* piece, const glm::vec3& size,
                float thickness) {
    // BEGIN TODO(build-a-table)
    const auto box = [](glm::vec3 a, glm::vec3 b) {
        const glm::mat4 S = glm::scale(glm::mat4(1.0f), b - a);
        const glm::mat4 T = glm::translate(glm::mat4(1.0f), 0.5f * (a + b));
        return T * S;
    };
    const glm::vec3 low(-size.x / 2.0f, 0.0f, -size.z / 2.0f);
    const glm::vec3 high(size.x / 2.0f, size.y, size.z / 2.0f);
    const float under = high.y - thickness;

    top.models.push_back(piece);
    top.modeltransforms.push_back(box(glm::vec3(low.x, under, low.z), high));
    leg.models.push_back(piece);
    leg.modeltransforms.push_back(box(low, glm::vec3(low.x + thickness, under, low.z + thickness)));

    table.childnodes = {&top, &leg, &leg, &leg, &leg};
    const float right = size.x - thickness, front = size.z - thickness;
    table.childtransforms = {glm::mat4(1.0f), glm::mat4(1.0f),
                             glm::translate(glm::mat4(1.0f), glm::vec3(right, 0.0f, 0.0f)),
                             glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, front)),
                             glm::translate(glm::mat4(1.0f), glm::vec3(right, 0.0f, front))};
    // END TODO(build-a-table)
}
