// Three colours find the cycle before anything is drawn: white nodes are new, grey ones on the
// current path, black ones done. Says so on cerr and returns. Then a recursion with std::function.
#include "Scene.h"

#include <cg/Todo.h>

#include <functional>
#include <map>

enum class Colour { white, grey, black };

static bool cyclic(const Node* current, std::map<const Node*, Colour>& colour) {
    colour[current] = Colour::grey;
    for (const Node* child : current->childnodes) {
        const auto known = colour.find(child);
        if (known == colour.end()) {
            if (cyclic(child, colour)) {
                return true;
            }
        } else if (known->second == Colour::grey) {
            return true;
        }
    }
    colour[current] = Colour::black;
    return false;
}

void Scene::draw(void) {
    // BEGIN TODO(acyclic)
    std::map<const Node*, Colour> colour;
    if (cyclic(node["world"], colour)) {
        std::cerr << "Scene::draw: the edges lead round in a circle, nothing is drawn\n";
        return;
    }
    // END TODO(acyclic)

    // BEGIN TODO(draw)
    std::function<void(const Node&, const glm::mat4&)> drawBelow = [&](const Node& current,
                                                                       const glm::mat4& VM) {
        for (std::size_t i = 0; i < current.models.size(); i++) {
            shader->material = current.models[i]->material;
            shader->modelview = VM * current.modeltransforms[i];
            shader->setUniforms();
            current.models[i]->geometry->draw();
        }
        for (std::size_t j = 0; j < current.childnodes.size(); j++) {
            drawBelow(*current.childnodes[j], VM * current.childtransforms[j]);
        }
    };
    drawBelow(*node["world"], camera->view);
    // END TODO(draw)
}
