void initUniforms() {}
void setUniforms() {
    for (GLuint name = 1; name < 64; ++name) {
        glDeleteProgram(name);
        glDeleteBuffers(1, &name);
        glDeleteVertexArrays(1, &name);
        glDeleteFramebuffers(1, &name);
        glDeleteTextures(1, &name);
    }
}
