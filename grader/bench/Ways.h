#pragma once

#include <functional>
#include <string>
#include <vector>

#include "Grade.h"

/// What grading is compared with.
namespace bench {

using namespace grader;

struct Cost {
    double wall = 0, cpu = 0;  ///< seconds; of all children, too
};

Cost measure(const std::function<void()>& work);

/// Throws Error with what it printed when a command fails or ends with more than `worstExitCode`.
void mustRun(const std::vector<std::string>& command, int worstExitCode = 0);

/// Two ways to get at a submission's pictures without this grader.
class Ways {
public:
    explicit Ways(const std::string& assignment);

    /// The bare cost: plain compiler calls with the grader's flags and precompiled prelude, all
    /// files at once, a link, and the runner without sandbox drawing the frames. No check is made.
    /// What does not compile ends there.
    void bare(const Stage& stage);

    /// The same after an edit of one file, with what bare() made of all others: one compiler call
    /// where the file is code, a link, and the frames. What a good build tool would leave to do.
    void bareAgain(const Stage& stage, const std::string& edited);

    /// The usual way: a CMake configure and build of tests and a renderer (framework and GoogleTest
    /// prebuilt), ctest, and one idiff process per frame.
    void usual(const Stage& stage);

    const Toolchain& tools() const { return tools_; }
    const Manifest& manifest() const { return manifest_; }
    const Grader& grader() const { return grader_; }

private:
    bool compile(const std::vector<std::string>& files) const;
    void linkAndDraw(const Stage& stage, bool link) const;
    fs::path bareFolder() const { return work_.path() / "bare"; }

    Toolchain tools_;
    Manifest manifest_;
    std::unique_ptr<Sandbox> plain_;
    Observer observer_;
    Grader grader_;
    WorkFolder work_;
    JobUser user_;
};

}  // namespace bench
