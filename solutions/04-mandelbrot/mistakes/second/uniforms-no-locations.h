    void initUniforms() {
        glUseProgram(program);
        setUniforms();
    }

    void setUniforms() {
        const auto real = [](GLint where, GLfloat value) { glUniform1f(where, value); };
        const GLfloat middle[] = {center.x, center.y};
        glUniform2fv(center_loc, 1, middle);
        real(zoom_loc, zoom);
        glUniform1iv(maxiter_loc, 1, &maxiter);
    }
