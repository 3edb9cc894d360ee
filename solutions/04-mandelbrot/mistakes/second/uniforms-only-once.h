    void initUniforms() {
        center_loc = glGetUniformLocation(program, "center");
        glUniform2fv(center_loc, 1, &center[0]);
        zoom_loc = glGetUniformLocation(program, "zoom");
        glUniform1fv(zoom_loc, 1, &zoom);
        maxiter_loc = glGetUniformLocation(program, "maxiter");
        glUniform1iv(maxiter_loc, 1, &maxiter);
    }

    void setUniforms() { glUseProgram(program); }
