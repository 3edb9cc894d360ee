    void initUniforms() {
        const char* const names[3] = {"center", "zoom", "maxiter"};
        GLint* const locations[3] = {&center_loc, &zoom_loc, &maxiter_loc};
        for (int i = 0; i < 3; ++i)
            *locations[i] = glGetUniformLocation(program, names[i]);
    }

    void setUniforms() {
        glUniform1iv(maxiter_loc, 1, &maxiter);
        const GLfloat middle[2] = {center[0], center[1]};
        glUniform2fv(center_loc, 1, middle);
    }
