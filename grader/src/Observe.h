#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "Build.h"
#include "Cgroup.h"
#include "Comparison.h"
#include "Manifest.h"
#include "compare/Picture.h"
#include "subject/Evidence.h"
#include "subject/Status.h"

namespace grader {

/// What became of one test of a judge's program.
struct TestOutcome {
    std::string suite, name, title, hint;
    std::vector<std::string> todos;  ///< unfilled regions that were reached
    judge::Verdict verdict{judge::Status::graderError, ""};
    bool hidden = false;
    std::optional<Comparison> comparison;
    std::vector<judge::Evidence> evidence;

    std::string id() const { return suite + "." + name; }
};

/// What became of one frame: a picture, or the reason why there is none.
struct FrameOutcome {
    Picture picture;
    judge::Verdict verdict{judge::Status::pass, ""};
    std::vector<std::string> todos;  ///< unfilled regions that were reached
    int undrawn = 0;  ///< pixels that were neither cleared nor drawn, as the subject's process says
};

struct Frames {
    protocol::GraphicsInfo graphics;
    bool possible = true;  ///< else OpenGL was at fault, before anything of the submission ran
    std::map<std::string, FrameOutcome> byId;
};

/// What draws the frames.
struct Renderer {
    std::string context = "auto";     ///< "osmesa", "egl", or "auto" for what the machine has
    std::string driver = "llvmpipe";  ///< "llvmpipe" or "softpipe", the two that Mesa has for CPUs
};

/// Asks a built subject, which runs in the sandbox, what it does.
class Observer {
public:
    Observer(const Toolchain& tools, const Sandbox& sandbox, Renderer renderer)
        : tools_(tools), sandbox_(sandbox), renderer_(std::move(renderer)) {}

    /// Runs the assignment's test program, in this trusted process's name.
    std::vector<TestOutcome> runTests(const Manifest& manifest, const BuildResult& build,
                                      std::uint64_t seed, const fs::path& work) const;

    /// Draws all frames of the manifest, in one process.
    Frames drawFrames(const Manifest& manifest, const BuildResult& build, std::uint64_t seed) const;

    /// What would draw; runs no submission. Throws Error that says why nothing does.
    protocol::GraphicsInfo describeGraphics(const Job& job) const;

    /// The tests there are, none of them run. Throws Error when there is no test program.
    std::vector<TestOutcome> listTests(const Manifest& manifest) const;

private:
    std::vector<std::string> runnerCommand(const Manifest& manifest, const BuildResult& build,
                                           const Cgroup& cgroup) const;

    const Toolchain& tools_;
    const Sandbox& sandbox_;
    Renderer renderer_;
};

/// The seconds after which tests and frames of a subject have ended, whatever it does.
double longestObservation(const Manifest& manifest);

}  // namespace grader
