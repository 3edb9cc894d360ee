    const float h = 1.0f / std::tan(glm::radians(fovy / 2.0f));
    const float sum = near + far, difference = near - far, product = near * far;
    proj = glm::mat4(h / aspect, 0.0f, 0.0f, 0.0f,                                    //
                     0.0f, h, 0.0f, 0.0f,                                             //
                     0.0f, 0.0f, sum / difference, 2.0f * product / difference,       //
                     0.0f, 0.0f, -1.0f, 0.0f);
