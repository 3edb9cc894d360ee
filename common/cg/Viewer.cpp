#include <cg/Error.h>
#include <cg/Resources.h>
#include <cg/Screenshot.h>
#include <cg/Todo.h>
#include <cg/Viewer.h>
#include <cg/gl.h>
#include <cg/image.h>

#include <exception>
#include <iostream>
#include <utility>

namespace cg {

namespace {

constexpr float stepDegrees = 10.0f;

}  // namespace

Viewer::Viewer(std::string name, std::string title, int width, int height)
    : name_(std::move(name)), title_(std::move(title)) {
    defaults_.width = width;
    defaults_.height = height;
}

Viewer::~Viewer() = default;

int Viewer::run(int argc, const char* const* argv) {
    try {
        const ViewerOptions options = parseViewerOptions(argc, argv, defaults_);
        if (options.help) {
            std::cout << viewerUsage(name_, defaults_);
        } else {
            show(options);
        }
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << name_ << ": " << failure.what() << std::endl;
        return 2;
    }
}

void Viewer::show(const ViewerOptions& options) {
    addResourceFolder(CG_FOLDER);
    announceTodos(true);
    const bool oneFrame = !options.screenshot.empty();
    GlfwContext context(options.width, options.height, windowTitle(),
                        oneFrame ? GlfwContext::Show::no : GlfwContext::Show::yes);
    init();
    if (oneFrame) {
        drawFrame(context);
        writeImage(options.screenshot, context.readPixels());
        return;
    }
    std::cout << "OpenGL " << context.version() << " on " << context.renderer() << "\n";
    printHelp();
    while (running_) {
        drawFrame(context);
        context.swapBuffers();
        for (const GlfwContext::Event event : context.waitEvents()) {
            handle(event);
            if (std::exchange(screenshotWanted_, false)) {
                takeScreenshot(context);
            }
        }
    }
}

void Viewer::takeScreenshot(GlfwContext& context) {
    // What the keys before this one led to, even when it is not on the screen yet.
    drawFrame(context);
    std::cout << "screenshot: " << saveScreenshot(name_, context.readPixels()) << std::endl;
}

void Viewer::drawFrame(GlfwContext& context) {
    glViewport(0, 0, context.width(), context.height());
    draw(static_cast<float>(context.width()) / static_cast<float>(context.height()));
    if (const std::string found = context.errors(); !found.empty()) {
        throw Error("OpenGL found a mistake while the picture was drawn: " + found);
    }
    context.setTitle(windowTitle());
}

void Viewer::handle(GlfwContext::Event event) {
    using Kind = GlfwContext::Event::Kind;
    switch (event.kind) {
        case Kind::left:
            arrow(-1, 0);
            break;
        case Kind::right:
            arrow(1, 0);
            break;
        case Kind::up:
            arrow(0, 1);
            break;
        case Kind::down:
            arrow(0, -1);
            break;
        case Kind::letter:
            pressed(event.letter);
            break;
        case Kind::escape:
        case Kind::close:
            running_ = false;
            break;
        case Kind::redraw:
            break;
    }
}

void Viewer::arrow(int right, int up) {
    // Opposite to the arrow, as if it moved the model instead of the camera.
    if (right != 0) {
        rotateRight(-stepDegrees * static_cast<float>(right));
    }
    if (up != 0) {
        rotateUp(-stepDegrees * static_cast<float>(up));
    }
}

void Viewer::pressed(char letter) {
    if (letter == 'h') {
        printHelp();
    } else if (letter == 'r') {
        reset();
    } else if (letter == 'o') {
        screenshotWanted_ = true;
    } else if (letter == 'p' && hasPerspective()) {
        perspective_ = !perspective_;
        printPerspective();
    } else {
        key(letter);
    }
}

void Viewer::printHelp() const {
    std::cout << name_ << ", " << title_ << ". Keys:\n"
              << "  h           this list\n"
              << "  arrow keys  " << arrowHelp() << "\n"
              << keyHelp() << "  r           back to the start\n"
              << (hasPerspective() ? "  p           perspective on or off\n" : "")
              << "  o           save a screenshot\n"
              << "  Esc         quit" << std::endl;
    if (hasPerspective()) {
        printPerspective();
    }
}

void Viewer::printPerspective() const {
    std::cout << "perspective: " << (perspective_ ? "on" : "off") << std::endl;
}

std::string Viewer::windowTitle() const {
    std::string text = name_ + ": " + title_;
    const char* separator = " - not implemented yet: ";
    for (const std::string& id : reachedTodos()) {
        text += separator + id;
        separator = ", ";
    }
    return text;
}

}  // namespace cg
