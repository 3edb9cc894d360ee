    void set(GLint location, GLfloat value) { glUniform1fv(location, 1, &value); }

    void initUniforms() {
        maxiter_loc = glGetUniformLocation(program, "maxiter");
        center_loc = glGetUniformLocation(program, "center");
        zoom_loc = glGetUniformLocation(program, "zoom");
    }

    void setUniforms() {
        set(maxiter_loc, GLfloat(maxiter));
        set(zoom_loc, zoom);
        glUniform2fv(center_loc, 1, &center.x);
    }
