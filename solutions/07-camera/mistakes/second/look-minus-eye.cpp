    view = glm::lookAt(eye, target, up);
    for (int row = 0; row < 3; ++row) {
        view[3][row] = -eye[row];
    }
