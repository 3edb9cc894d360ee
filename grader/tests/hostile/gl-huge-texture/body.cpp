void initUniforms() {}
void setUniforms() {
    for (int i = 0; i < 4096; ++i) {
        GLuint name = 0;
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D, name);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 8192, 8192, 0, GL_RGBA, GL_FLOAT, nullptr);
    }
}
