    GLint location(const char* name) const { return glGetUniformLocation(program, name); }

    void initUniforms() {
        maxiter_loc = location("maxiter");
        zoom_loc = location("zoom");
        center_loc = location("centre");
    }

    void setUniforms() {
        glUniform1iv(maxiter_loc, 1, &maxiter);
        glUniform1fv(zoom_loc, 1, &zoom);
        glUniform2fv(center_loc, 1, &center[0]);
    }
