#pragma once

#include <cg/Context.h>

#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace cg {

/// A context in a window of the desktop, by GLFW: OpenGL 3.3 core, double buffered, 24 bits of
/// depth, no multisampling, whatever GPU there is. One at a time.
/// What happens to the window is kept in a list, so that nothing is thrown through GLFW.
class GlfwContext : public Context {
public:
    struct Event {
        enum class Kind {
            left,
            right,
            up,
            down,
            escape,
            letter,  ///< `letter` holds it, as the keyboard's layout says, in lower case; or + - =
            redraw,  ///< new size, or the window came into sight
            close,
        };
        Kind kind;
        char letter = 0;
    };

    enum class Show { yes, no };

    /// Opens the window, of this size in screen units, and makes its context current.
    /// Throws cg::Error: no display, no OpenGL 3.3.
    GlfwContext(int width, int height, const std::string& title, Show show);
    ~GlfwContext() override;

    const char* provider() const override { return "glfw"; }
    void makeCurrent() override;
    void* function(const char* name) const override;

    void setTitle(const std::string& title);

    /// Shows what was drawn.
    void swapBuffers();

    /// Waits until something has happened and returns all of it, oldest first. After this, width()
    /// and height() are up to date; a minimised window keeps its last size.
    std::vector<Event> waitEvents();

private:
    /// GLFW itself, which must outlive its window.
    struct Library {
        Library();
        ~Library();
    };
    struct Close {
        void operator()(GLFWwindow* window) const;
    };

    void listen();
    void readSize();
    void note(Event event) { events_.push_back(event); }

    Library library_;
    std::unique_ptr<GLFWwindow, Close> window_;
    std::vector<Event> events_;
};

}  // namespace cg
