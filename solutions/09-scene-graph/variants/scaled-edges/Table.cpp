// The scaling is in the edges, not in the models: top and leg hold the bare cube, raised so that it
// stands on its node's origin. Moves are accumulated by *=, scale after translate.
#include "Table.h"

#include <glm/gtc/matrix_transform.hpp>

namespace {

void attach(Node& parent, Node& child, const glm::vec3& foot, const glm::vec3& extent) {
    glm::mat4 transform(1.0f);
    transform *= glm::translate(glm::mat4(1.0f), foot);
    transform *= glm::scale(glm::mat4(1.0f), extent);
    parent.childnodes.push_back(&child);
    parent.childtransforms.push_back(transform);
}

}  // namespace

void buildTable(Node& table, Node& top, Node& leg, Model* piece, const glm::vec3& size,
                float thickness) {
    for (Node* part : {&top, &leg}) {
        part->models.push_back(piece);
        part->modeltransforms.push_back(
            glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.5f, 0.0f)));
    }

    const float height = size.y - thickness;
    const glm::vec3 post(thickness, height, thickness);
    attach(table, top, glm::vec3(0.0f, height, 0.0f), glm::vec3(size.x, thickness, size.z));
    for (int corner = 0; corner < 4; ++corner) {
        glm::vec3 foot = (size - post) / 2.0f;
        foot.y = 0.0f;
        if (corner % 2 == 0) {
            foot.x = -foot.x;
        }
        if (corner < 2) {
            foot.z = -foot.z;
        }
        attach(table, leg, foot, post);
    }
}
