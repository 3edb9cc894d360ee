// Draws every frame of a harness to PNG files in the folder given.
#include <cg/OsMesaContext.h>
#include <cg/gl.h>
#include <cg/image.h>
#include <runner/Harness.h>

extern "C" void cg_register_harness(Harness& harness);

int main(int, char** argv) {
    Harness harness;
    cg_register_harness(harness);
    harness.addResourceFolder(RESOURCES);
    const auto context = cg::createOsMesaContext(400, 300);
    for (const auto& [id, draw] : harness.frames) {
        glViewport(0, 0, 400, 300);
        draw({400, 300, 1});
        cg::writeImage(std::string(argv[1]) + "/" + id + ".png", context->readPixels());
    }
}
