    void initUniforms() {
        center_loc = glGetUniformLocation(program, "center");
        zoom_loc = glGetUniformLocation(program, "zoom");
        maxiter_loc = glGetUniformLocation(program, "maxiter");
    }

    void setUniforms() {
        glUniform2f(center_loc, center.x, 0.0f);
        glUniform1f(zoom_loc, zoom);
        glUniform1i(maxiter_loc, maxiter);
    }
