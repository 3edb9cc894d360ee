    void initUniforms() {
        const char* const names[] = {"center", "zoom", "maxiter"};
        GLint found[3];
        for (int i = 0; i < 3; ++i)
            found[i] = glGetUniformLocation(program, names[i]);
        center_loc = found[0];
        zoom_loc = found[1];
        maxiter_loc = found[2];
    }

    void setUniforms() {
        glm::vec2 middle = center;
        middle *= zoom;
        glUniform2fv(center_loc, 1, &middle[0]);
        glUniform1fv(zoom_loc, 1, &zoom);
        glUniform1iv(maxiter_loc, 1, &maxiter);
    }
