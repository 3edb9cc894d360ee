// A class does the drawing. It collects all models with their matrices first, the view left out,
// and draws the list only if no path came out longer than there are nodes; else the program ends.
#include "Scene.h"

#include <cstdlib>
#include <utility>

using namespace std;

namespace {

class Collector {
public:
    explicit Collector(size_t longest) : longest_(longest) {}

    bool collect(const Node* current, const glm::mat4& toWorld, size_t edges = 0) {
        if (edges >= longest_)
            return false;
        for (size_t j = 0; j < current->childnodes.size(); j++) {
            if (!collect(current->childnodes[j], toWorld * current->childtransforms[j], edges + 1))
                return false;
        }
        for (size_t i = 0; i < current->models.size(); i++)
            found.push_back(make_pair(current->models[i], toWorld * current->modeltransforms[i]));
        return true;
    }

    vector<pair<Model*, glm::mat4>> found;

private:
    size_t longest_;
};

}  // namespace

void Scene::draw(void) {
    Collector collector(node.size());
    if (!collector.collect(node["world"], glm::mat4(1.0f))) {
        cout << "ERROR: the scene graph is not acyclic" << endl;
        exit(EXIT_FAILURE);
    }
    for (const pair<Model*, glm::mat4>& each : collector.found) {
        shader->modelview = camera->view * each.second;
        shader->material = each.first->material;
        shader->setUniforms();
        each.first->geometry->draw();
    }
}
