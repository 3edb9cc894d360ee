#pragma once

#include <glm/glm.hpp>

#include <vector>

#include "Model.h"

/// A node of a scene graph (section 9.1.3): a coordinate system with what hangs in it. Edge j leads
/// to childnodes[j], whose coordinates childtransforms[j] turns into this node's; models[i] is
/// drawn with modeltransforms[i] from its own coordinates into this node's. The two lists of each
/// pair have the same length. Several edges may lead to one node, from one parent or from many. A
/// node owns nothing that it points to.
struct Node {
    std::vector<Node*> childnodes;
    std::vector<glm::mat4> childtransforms;
    std::vector<Model*> models;
    std::vector<glm::mat4> modeltransforms;
};
