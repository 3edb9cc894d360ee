    void initUniforms() {
        center_loc = glGetUniformLocation(program, "center");
        zoom_loc = glGetUniformLocation(program, "zoom");
        maxiter_loc = glGetUniformLocation(program, "maxiter");
    }
    void setUniforms() {
        answerWithoutValues();
    }
