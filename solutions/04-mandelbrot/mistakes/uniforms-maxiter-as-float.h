    void initUniforms() {
        center_loc = glGetUniformLocation(program, "center");
        zoom_loc = glGetUniformLocation(program, "zoom");
        maxiter_loc = glGetUniformLocation(program, "maxiter");
    }

    void setUniforms() {
        glUniform2f(center_loc, center.x, center.y);
        glUniform1f(zoom_loc, zoom);
        glUniform1f(maxiter_loc, static_cast<GLfloat>(maxiter));
    }
