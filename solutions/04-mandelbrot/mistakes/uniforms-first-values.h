    void initUniforms() {
        center_loc = glGetUniformLocation(program, "center");
        zoom_loc = glGetUniformLocation(program, "zoom");
        maxiter_loc = glGetUniformLocation(program, "maxiter");
    }

    void setUniforms() {
        static bool done = false;
        if (done) {
            return;
        }
        done = true;
        glUniform2f(center_loc, center.x, center.y);
        glUniform1f(zoom_loc, zoom);
        glUniform1i(maxiter_loc, maxiter);
    }
