    void initUniforms() {
        center_loc = glGetUniformLocation(program, "center");
        zoom_loc = glGetUniformLocation(program, "zoom");
    }

    void setUniforms() {
        const GLfloat values[3] = {center.x, center.y, zoom};
        glUniform2fv(center_loc, 1, values);
        glUniform1fv(zoom_loc, 1, values + 2);
    }
