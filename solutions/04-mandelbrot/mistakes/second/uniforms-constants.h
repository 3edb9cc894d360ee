    struct Start {
        glm::vec2 center{0.0f, 0.0f};
        GLfloat zoom = 2.0f;
        GLint maxiter = 50;
    };

    void initUniforms() {
        maxiter_loc = glGetUniformLocation(program, "maxiter");
        zoom_loc = glGetUniformLocation(program, "zoom");
        center_loc = glGetUniformLocation(program, "center");
    }

    void setUniforms() {
        const Start start;
        glUniform2fv(center_loc, 1, &start.center[0]);
        glUniform1fv(zoom_loc, 1, &start.zoom);
        glUniform1iv(maxiter_loc, 1, &start.maxiter);
    }
