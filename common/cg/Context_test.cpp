#include <cg/Error.h>
#include <cg/GlTest.h>

namespace {

using ContextTest = cg::GlTest;
using cg::Context;
using cg::Error;
using cg::Pixels;

void fill(int x, int y, int width, int height, float red, float green) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, width, height);
    glClearColor(red, green, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

TEST_F(ContextTest, IsACoreContextOnTheCpu) {
    EXPECT_STREQ(context->provider(), "osmesa");
    EXPECT_GE(context->version(), "3.3");
    EXPECT_NE(context->renderer().find("llvmpipe"), std::string::npos) << context->renderer();
    EXPECT_NE(context->function("glReadPixels"), nullptr);
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
    GLint depthBits = 0;
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                          GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &depthBits);
    EXPECT_EQ(depthBits, 24);
}

TEST_F(ContextTest, AResizedFramebufferKeepsGlObjects) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    context->resizeFramebuffer(30, 20);
    EXPECT_TRUE(glIsBuffer(buffer));
    glViewport(0, 0, 30, 20);
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const Pixels pixels = context->readPixels();
    ASSERT_EQ(pixels.rgba.size(), 30u * 20u * 4u);
    EXPECT_EQ(pixels.rgba[pixels.rgba.size() - 3], 255);
    glDeleteBuffers(1, &buffer);
}

TEST_F(ContextTest, RowZeroOfAPictureIsTheTop) {
    fill(0, 0, 64, 48, 1, 0);
    fill(0, 47, 1, 1, 0, 1);  // GL counts rows from the bottom
    const Pixels pixels = context->readPixels();
    ASSERT_EQ(pixels.width, 64);
    ASSERT_EQ(pixels.height, 48);
    ASSERT_EQ(pixels.rgba.size(), 64u * 48u * 4u);
    EXPECT_EQ(pixels.rgba[0], 0);
    EXPECT_EQ(pixels.rgba[1], 255);
    EXPECT_EQ(pixels.rgba[4], 255);
    EXPECT_EQ(pixels.rgba[pixels.rgba.size() - 4], 255);
    EXPECT_EQ(pixels.rgba[3], 255);
}

TEST_F(ContextTest, ReadsRowsOfOddWidthWhateverTheStateOfGl) {
    context = cg::createOsMesaContext(33, 5);
    fill(0, 0, 33, 5, 0, 1);
    fill(32, 0, 1, 5, 1, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_PACK_ROW_LENGTH, 100);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glEnable(GL_POINTS);  // a student's error before must not count against reading
    const Pixels pixels = context->readPixels();
    for (std::size_t row = 0; row < 5; ++row) {
        EXPECT_EQ(pixels.rgba[(row * 33 + 31) * 4 + 1], 255);
        EXPECT_EQ(pixels.rgba[(row * 33 + 32) * 4], 255);
    }
}

TEST_F(ContextTest, NamesPendingErrors) {
    glEnable(GL_POINTS);
    EXPECT_EQ(context->errors(), "GL_INVALID_ENUM");
    EXPECT_EQ(context->errors(), "");
}

TEST_F(ContextTest, OnlyTheCurrentContextMayBeRead) {
    const unsigned first = cg::currentContextId();
    const auto other = cg::createOsMesaContext(8, 8);
    EXPECT_NE(cg::currentContextId(), first);
    EXPECT_THROW(context->readPixels(), Error);
    context->makeCurrent();
    EXPECT_EQ(cg::currentContextId(), first);
    context->readPixels();
    context.reset();
    EXPECT_EQ(cg::currentContextId(), 0u);
}

TEST_F(ContextTest, RefusesAnImpossibleSize) {
    EXPECT_NE(cg::messageOf<Error>([] { cg::createOsMesaContext(0, 10); }).find("0 x 10"),
              std::string::npos);
    EXPECT_NE(cg::messageOf<Error>([] { cg::createOsMesaContext(100000, 1); }).find("100000 x 1"),
              std::string::npos);
}

}  // namespace
