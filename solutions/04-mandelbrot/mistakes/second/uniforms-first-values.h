    bool dirty = true;

    void initUniforms() {
        const auto find = [this](const char* name) { return glGetUniformLocation(program, name); };
        center_loc = find("center"), zoom_loc = find("zoom"), maxiter_loc = find("maxiter");
    }

    void setUniforms() {
        if (dirty) {
            glUniform1iv(maxiter_loc, 1, &maxiter);
            glUniform1fv(zoom_loc, 1, &zoom);
            glUniform2fv(center_loc, 1, &center[0]);
        }
        dirty = false;
    }
