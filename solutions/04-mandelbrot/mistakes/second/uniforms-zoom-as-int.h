    void set(GLint location, GLint value) { glUniform1i(location, value); }

    void initUniforms() {
        maxiter_loc = glGetUniformLocation(program, "maxiter");
        center_loc = glGetUniformLocation(program, "center");
        zoom_loc = glGetUniformLocation(program, "zoom");
    }

    void setUniforms() {
        set(maxiter_loc, maxiter);
        set(zoom_loc, GLint(zoom));
        glUniform2fv(center_loc, 1, &center.x);
    }
