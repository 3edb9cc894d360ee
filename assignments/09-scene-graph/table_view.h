// A student's table, followed from its node downwards.
#pragma once

#include <glm/glm.hpp>

#include <stdexcept>
#include <vector>

#include "Table.h"
#include "table_fault.h"

namespace course {

/// The cube's matrix for the same box, if it is one along the axes: neither turned nor mirrored. So
/// a picture by normals does not depend on which way round a cube lies in its box.
inline glm::mat4 upright(const glm::mat4& piece) {
    glm::vec3 extent(0.0f);
    int alongAnAxis = 0;
    for (int column = 0; column < 3; ++column) {
        const glm::vec3 edge = glm::abs(glm::vec3(piece[column]));
        const float longest = glm::max(edge.x, glm::max(edge.y, edge.z));
        alongAnAxis += edge.x + edge.y + edge.z - longest <= 1e-5f * longest;
        extent += edge;
    }
    if (alongAnAxis < 3) {
        return piece;
    }
    glm::mat4 box(glm::mat3(extent.x, 0, 0, 0, extent.y, 0, 0, 0, extent.z));
    box[3] = piece[3];
    return box;
}

/// Thrown when the graph cannot be followed; the text is meant for the author of buildTable.
struct FaultyTable : std::runtime_error {
    explicit FaultyTable(const TableFault& why) : std::runtime_error(why.tell()), fault(why) {}
    TableFault fault;
};

/// Calls buildTable with three empty nodes and follows every path from the table's. After the call
/// a foot, a second model, is hung in the leg's node with the identity. Throws FaultyTable.
struct TableView {
    std::vector<glm::mat4>
        pieces;  ///< one for each path to the piece: from its coordinates to the table's
    std::vector<glm::mat4> feet;  ///< the same for the foot
    glm::mat4 legPiece{0.0f};     ///< first model transform of `leg`; zero when it has no model
    int legEdges = 0;             ///< edges from the node `table` to the node `leg`

    TableView(const glm::vec3& size, float thickness) {
        buildTable(table_, top_, leg_, &piece_, size, thickness);
        requireModels(&leg_);
        if (!leg_.models.empty()) {
            legPiece = leg_.modeltransforms.front();
        }
        leg_.models.push_back(&foot_);
        leg_.modeltransforms.push_back(glm::mat4(1.0f));
        follow(&table_, glm::mat4(1.0f), 0);
    }

private:
    void follow(const Node* node, const glm::mat4& matrix, int depth) {
        constexpr int deepest = 16;
        constexpr std::size_t most = 1000;
        if (depth > deepest || pieces.size() > most) {
            throw FaultyTable({TableFault::cycle, placeOf(node)});
        }
        requireModels(node);
        require(node, node->childnodes.size(), node->childtransforms.size(),
                TableFault::childWithoutTransform, TableFault::transformWithoutChild);
        for (std::size_t i = 0; i < node->models.size(); ++i) {
            if (node->models[i] != &piece_ && node->models[i] != &foot_) {
                throw FaultyTable({TableFault::otherModel, placeOf(node)});
            }
            (node->models[i] == &piece_ ? pieces : feet)
                .push_back(matrix * node->modeltransforms[i]);
        }
        for (std::size_t j = 0; j < node->childnodes.size(); ++j) {
            const Node* child = node->childnodes[j];
            if (child == nullptr) {
                throw FaultyTable({TableFault::noChild, placeOf(node)});
            }
            legEdges += node == &table_ && child == &leg_;
            follow(child, matrix * node->childtransforms[j], depth + 1);
        }
    }

    TableFault::Place placeOf(const Node* node) const {
        return node == &table_ ? TableFault::table
               : node == &top_ ? TableFault::top
               : node == &leg_ ? TableFault::leg
                               : TableFault::elsewhere;
    }

    void requireModels(const Node* node) const {
        require(node, node->models.size(), node->modeltransforms.size(),
                TableFault::modelWithoutTransform, TableFault::transformWithoutModel);
    }

    void require(const Node* node, std::size_t entries, std::size_t transforms,
                 TableFault::Kind tooFew, TableFault::Kind tooMany) const {
        if (entries != transforms) {
            throw FaultyTable({entries > transforms ? tooFew : tooMany, placeOf(node), int(entries),
                               int(transforms)});
        }
    }

    Node table_, top_, leg_;
    Model piece_, foot_;
};

}  // namespace course
