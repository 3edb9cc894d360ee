    void initUniforms() {
        center_loc = glGetUniformLocation(program, "zoom");
        zoom_loc = glGetUniformLocation(program, "center");
        maxiter_loc = glGetUniformLocation(program, "maxiter");
    }

    void setUniforms() {
        glUniform2f(center_loc, center.x, center.y);
        glUniform1f(zoom_loc, zoom);
        glUniform1i(maxiter_loc, maxiter);
    }
