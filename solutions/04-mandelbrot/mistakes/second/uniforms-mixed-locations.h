    GLint at(const char* name) { return glGetUniformLocation(program, name); }

    void initUniforms() {
        center_loc = at("center");
        zoom_loc = at("zoom");
        maxiter_loc = at("maxiter");
    }

    void setUniforms() {
        glUniform1iv(maxiter_loc, 1, &maxiter);
        glUniform1fv(center_loc, 1, &zoom);
        glUniform2fv(zoom_loc, 1, &center[0]);
    }
