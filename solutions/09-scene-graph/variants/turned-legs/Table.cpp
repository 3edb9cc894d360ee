// The origins lie elsewhere than in the solution: a leg hangs from its node at a corner of the top,
// two of the four are turned by a half turn, and the top has its transform on the edge.
#include "Table.h"

#include <glm/gtc/matrix_transform.hpp>

void buildTable(Node& table, Node& top, Node& leg, Model* piece, const glm::vec3& size,
                float thickness) {
    const glm::mat4 I(1.0f);
    const float h = size.y - thickness;
    leg.models = {piece};
    leg.modeltransforms = {glm::scale(glm::translate(I, glm::vec3(thickness, -h, thickness) / 2.0f),
                                      glm::vec3(thickness, h, -thickness))};
    for (const float degrees : {0.0f, 180.0f}) {
        const glm::mat4 half = glm::rotate(I, glm::radians(degrees), glm::vec3(0, 1, 0));
        const glm::vec3 corner(-size.x / 2, h, -size.z / 2);
        table.childnodes.insert(table.childnodes.end(), 2, &leg);
        table.childtransforms.push_back(half * glm::translate(I, corner));
        table.childtransforms.push_back(
            half * glm::translate(I, corner + glm::vec3(0, 0, size.z - thickness)));
    }
    table.childnodes.push_back(&top);
    table.childtransforms.push_back(
        glm::scale(glm::translate(I, glm::vec3(0, h + thickness / 2, 0)),
                   glm::vec3(size.x, thickness, size.z)));
    top.models = {piece};
    top.modeltransforms = {I};
}
