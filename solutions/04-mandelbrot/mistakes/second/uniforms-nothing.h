    void initUniforms() {
        const auto find = [this](const char* name) { return glGetUniformLocation(program, name); };
        center_loc = find("center");
        zoom_loc = find("zoom");
        maxiter_loc = find("maxiter");
    }

    void setUniforms() {
        if (center_loc < 0)
            glUniform2fv(center_loc, 1, &center[0]);
        if (zoom_loc < 0)
            glUniform1fv(zoom_loc, 1, &zoom);
        if (maxiter_loc < 0)
            glUniform1iv(maxiter_loc, 1, &maxiter);
    }
