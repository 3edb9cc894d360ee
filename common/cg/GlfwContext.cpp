#include <cg/Error.h>
#include <cg/GlfwContext.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <optional>

namespace cg {
namespace {

using Event = GlfwContext::Event;
using Kind = Event::Kind;

[[noreturn]] void fail(const std::string& what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw Error(what + " (GLFW: " + (reason == nullptr ? "no reason given" : reason) + ")");
}

std::optional<Kind> kindOf(int key) {
    switch (key) {
        case GLFW_KEY_LEFT:
            return Kind::left;
        case GLFW_KEY_RIGHT:
            return Kind::right;
        case GLFW_KEY_UP:
            return Kind::up;
        case GLFW_KEY_DOWN:
            return Kind::down;
        case GLFW_KEY_ESCAPE:
            return Kind::escape;
        default:
            return std::nullopt;
    }
}

std::optional<char> letterOf(unsigned codepoint) {
    if (codepoint >= 'A' && codepoint <= 'Z') {
        return static_cast<char>(codepoint - 'A' + 'a');
    }
    if (codepoint >= 'a' && codepoint <= 'z') {
        return static_cast<char>(codepoint);
    }
    if (codepoint == '+' || codepoint == '-' || codepoint == '=') {
        return static_cast<char>(codepoint);
    }
    return std::nullopt;
}

}  // namespace

GlfwContext::Library::Library() {
    if (glfwInit() == GLFW_FALSE) {
        fail("no window can be opened here: is there a display?");
    }
}

GlfwContext::Library::~Library() {
    glfwTerminate();
}

void GlfwContext::Close::operator()(GLFWwindow* window) const {
    glfwDestroyWindow(window);
}

GlfwContext::GlfwContext(int width, int height, const std::string& title, Show show)
    : Context(width, height) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHint(GLFW_SAMPLES, 0);
    glfwWindowHint(GLFW_VISIBLE, show == Show::yes ? GLFW_TRUE : GLFW_FALSE);
    window_.reset(glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr));
    if (!window_) {
        fail("no window with OpenGL 3.3 core can be opened here");
    }
    makeCurrent();
    glfwSwapInterval(1);
    listen();
    readSize();
}

GlfwContext::~GlfwContext() = default;

void GlfwContext::makeCurrent() {
    glfwMakeContextCurrent(window_.get());
    if (glfwGetCurrentContext() != window_.get()) {
        fail("the window's OpenGL context cannot be used");
    }
    becomeCurrent();
}

void* GlfwContext::function(const char* name) const {
    return reinterpret_cast<void*>(glfwGetProcAddress(name));
}

void GlfwContext::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_.get(), title.c_str());
}

void GlfwContext::swapBuffers() {
    glfwSwapBuffers(window_.get());
}

std::vector<Event> GlfwContext::waitEvents() {
    if (events_.empty()) {
        glfwWaitEvents();
    } else {
        glfwPollEvents();
    }
    readSize();
    std::vector<Event> happened;
    happened.swap(events_);
    return happened;
}

void GlfwContext::listen() {
    GLFWwindow* window = window_.get();
    glfwSetWindowUserPointer(window, this);
    static const auto owner = [](GLFWwindow* of) {
        return static_cast<GlfwContext*>(glfwGetWindowUserPointer(of));
    };
    glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int, int action, int) {
        if (const auto kind = kindOf(key); kind && action != GLFW_RELEASE) {
            owner(of)->note({*kind});
        }
    });
    glfwSetCharCallback(window, [](GLFWwindow* of, unsigned codepoint) {
        if (const auto letter = letterOf(codepoint)) {
            owner(of)->note({Kind::letter, *letter});
        }
    });
    glfwSetFramebufferSizeCallback(
        window, [](GLFWwindow* of, int, int) { owner(of)->note({Kind::redraw}); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* of) { owner(of)->note({Kind::redraw}); });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* of) { owner(of)->note({Kind::close}); });
}

void GlfwContext::readSize() {
    int newWidth = 0;
    int newHeight = 0;
    glfwGetFramebufferSize(window_.get(), &newWidth, &newHeight);
    if (newWidth > 0 && newHeight > 0) {
        resize(newWidth, newHeight);
    }
}

}  // namespace cg
