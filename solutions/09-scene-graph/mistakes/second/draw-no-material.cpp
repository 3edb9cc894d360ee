    struct Step {
        Node* at;
        glm::mat4 product;
    };
    std::stack<Step> steps;
    steps.push(Step{node["world"], glm::mat4(1.0f)});
    do {
        const Step step = steps.top();
        steps.pop();
        std::size_t k = 0;
        for (Model* model : step.at->models) {
            shader->modelview = camera->view * (step.product * step.at->modeltransforms[k++]);
            shader->setUniforms();
            model->geometry->draw();
        }
        k = 0;
        for (Node* next : step.at->childnodes) {
            steps.push(Step{next, step.product * step.at->childtransforms[k++]});
        }
    } while (!steps.empty());
