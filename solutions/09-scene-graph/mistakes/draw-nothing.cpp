    shader->setUniforms();
