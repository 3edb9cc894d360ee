// One pair of loops over -1 and 1 makes the legs; matrices are written entry by entry, without
// glm::translate and glm::scale. Legs come before the top, edges before what is in the nodes.
#include "Table.h"

void buildTable(Node& table, Node& top, Node& leg, Model* piece, const glm::vec3& size,
                float thickness) {
    for (int i = -1; i <= 1; i += 2) {
        for (int k = -1; k <= 1; k += 2) {
            glm::mat4 edge(1.0f);
            edge[3].x = i * (size.x - thickness) / 2;
            edge[3].y = (size.y - thickness) / 2;
            edge[3].z = k * (size.z - thickness) / 2;
            table.childtransforms.push_back(edge);
            table.childnodes.push_back(&leg);
        }
    }
    glm::mat4 edge(1.0f);
    edge[3].y = size.y - thickness / 2;
    table.childtransforms.push_back(edge);
    table.childnodes.push_back(&top);

    glm::mat4 post(1.0f), board(1.0f);
    post[0][0] = post[2][2] = board[1][1] = thickness;
    post[1][1] = size.y - thickness;
    board[0][0] = size.x;
    board[2][2] = size.z;
    leg.modeltransforms.push_back(post);
    leg.models.push_back(piece);
    top.modeltransforms.push_back(board);
    top.models.push_back(piece);
}
