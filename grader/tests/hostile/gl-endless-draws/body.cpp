void initUniforms() {}
void setUniforms() {
    for (;;) glClear(GL_COLOR_BUFFER_BIT);
}
