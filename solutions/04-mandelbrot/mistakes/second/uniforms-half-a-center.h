    void initUniforms() {
        for (auto [place, name] : {std::pair{&center_loc, "center"}, std::pair{&zoom_loc, "zoom"},
                                   std::pair{&maxiter_loc, "maxiter"}})
            *place = glGetUniformLocation(program, name);
    }

    void setUniforms() {
        GLfloat parts[2] = {};
        parts[0] = center.x;
        glUniform2fv(center_loc, 1, parts);
        glUniform1fv(zoom_loc, 1, &zoom);
        glUniform1iv(maxiter_loc, 1, &maxiter);
    }
