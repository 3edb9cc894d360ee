#include <cg/Error.h>
#include <cg/FramebufferObject.h>
#include <cg/gl.h>

namespace cg {

void FramebufferObject::make() {
    const auto gl = [this]<class Function>(Function*& into, const char* name) {
        into = reinterpret_cast<Function*>(context_.function(name));
    };
    PFNGLGENFRAMEBUFFERSPROC genFramebuffers;
    PFNGLDELETEFRAMEBUFFERSPROC deleteFramebuffers;
    PFNGLBINDFRAMEBUFFERPROC bindFramebuffer;
    PFNGLGENRENDERBUFFERSPROC genRenderbuffers;
    PFNGLDELETERENDERBUFFERSPROC deleteRenderbuffers;
    PFNGLBINDRENDERBUFFERPROC bindRenderbuffer;
    PFNGLRENDERBUFFERSTORAGEPROC storage;
    PFNGLFRAMEBUFFERRENDERBUFFERPROC attach;
    PFNGLCHECKFRAMEBUFFERSTATUSPROC check;
    PFNGLVIEWPORTPROC viewport;
    gl(genFramebuffers, "glGenFramebuffers");
    gl(deleteFramebuffers, "glDeleteFramebuffers");
    gl(bindFramebuffer, "glBindFramebuffer");
    gl(genRenderbuffers, "glGenRenderbuffers");
    gl(deleteRenderbuffers, "glDeleteRenderbuffers");
    gl(bindRenderbuffer, "glBindRenderbuffer");
    gl(storage, "glRenderbufferStorage");
    gl(attach, "glFramebufferRenderbuffer");
    gl(check, "glCheckFramebufferStatus");
    gl(viewport, "glViewport");

    if (framebuffer_ != 0) {
        deleteFramebuffers(1, &framebuffer_);
        deleteRenderbuffers(2, renderbuffers_);
    }
    genFramebuffers(1, &framebuffer_);
    bindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    genRenderbuffers(2, renderbuffers_);
    const GLenum formats[] = {GL_RGBA8, GL_DEPTH24_STENCIL8};
    const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
        bindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[i]);
        storage(GL_RENDERBUFFER, formats[i], context_.width(), context_.height());
        attach(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, renderbuffers_[i]);
    }
    if (check(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw Error("GL gives no framebuffer of " + std::to_string(context_.width()) + " x " +
                    std::to_string(context_.height()) + " pixels");
    }
    viewport(0, 0, context_.width(), context_.height());
}

}  // namespace cg
