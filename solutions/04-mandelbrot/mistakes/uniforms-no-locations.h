    void initUniforms() {}

    void setUniforms() {
        glUniform2f(center_loc, center.x, center.y);
        glUniform1f(zoom_loc, zoom);
        glUniform1i(maxiter_loc, maxiter);
    }
