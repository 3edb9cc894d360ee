#include <cg/Context.h>
#include <cg/Ownership.h>
#include <cg/gl.h>

namespace cg {

bool mayDelete(unsigned madeIn) noexcept {
    if (madeIn != 0) {
        return madeIn == currentContextId();
    }
    // Without a current context, GL answers every question with zero.
    return glGetString(GL_VERSION) != nullptr;
}

}  // namespace cg
