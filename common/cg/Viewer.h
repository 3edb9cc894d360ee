#pragma once

#include <cg/GlfwContext.h>
#include <cg/ViewerOptions.h>

#include <string>

namespace cg {

/// The model viewer of section 7.6.2: a window in which arrow keys turn something. A derived class
/// says what is drawn and what the keys do:
///
///     h          prints the keys          Left, Right   rotateRight(+10), rotateRight(-10)
///     Esc        quits                    Up, Down      rotateUp(-10), rotateUp(+10)
///     r          reset()                  o             saves a screenshot in the current folder
///     p          switches perspective (where hasPerspective())
///     others     key(), named in keyHelp()
///
/// The title names the tasks that were reached and are not implemented. A resized window keeps the
/// picture undistorted: the viewport is set here, and draw() is told the aspect ratio.
class Viewer {
public:
    /// `name` ("07-camera") begins the title and names the screenshots; `title` says more.
    /// The window is width x height screen units unless the command line says otherwise.
    Viewer(std::string name, std::string title, int width = 800, int height = 600);
    Viewer(const Viewer&) = delete;
    Viewer& operator=(const Viewer&) = delete;
    virtual ~Viewer();

    /// The whole program. Returns the exit code: 0, or 2 after printing to stderr what went wrong
    /// (a bad option, no display, a shader that does not compile, a GL error while drawing).
    int run(int argc, const char* const* argv);

protected:
    virtual void init() = 0;              ///< once, with the context current
    virtual void draw(float aspect) = 0;  ///< a whole picture; aspect is width / height
    virtual void reset() = 0;             ///< back to the start
    virtual void rotateRight(float /*degrees*/) {}
    virtual void rotateUp(float /*degrees*/) {}
    virtual bool hasPerspective() const { return false; }

    /// An arrow key: right is 1 for the right one and -1 for the left one, up likewise, the other
    /// is 0. Turns, unless a derived class does something else.
    virtual void arrow(int right, int up);
    virtual std::string arrowHelp() const { return "turn by 10 degrees"; }

    /// Any other letter, in lower case, or one of + - =. Lines for keyHelp(): "  a closer\n".
    virtual void key(char /*letter*/) {}
    virtual std::string keyHelp() const { return ""; }

    bool perspective() const { return perspective_; }

private:
    void show(const ViewerOptions& options);
    void drawFrame(GlfwContext& context);
    void takeScreenshot(GlfwContext& context);
    void handle(GlfwContext::Event event);
    void pressed(char letter);
    void printHelp() const;
    void printPerspective() const;
    std::string windowTitle() const;

    std::string name_;
    std::string title_;
    ViewerOptions defaults_;
    bool perspective_ = false;
    bool screenshotWanted_ = false;
    bool running_ = true;
};

}  // namespace cg
