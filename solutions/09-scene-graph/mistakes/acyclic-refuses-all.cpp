    throw std::runtime_error("the scene graph has a cycle");
