#pragma once

#include <cg/Context.h>

#include <memory>
#include <string>

#include "protocol/Message.h"
#include "runner/Harness.h"

namespace runner {

/// What the runner hosts.
struct SubjectFiles {
    std::string object;          ///< the subject's shared object
    std::string resourceFolder;  ///< shaders of the framework; searched after the working folder
    std::string provider;        ///< of OpenGL contexts: "osmesa", "egl", "auto"
};

/// A child process's side: loads the subject, serves requests one after the other. Whatever goes
/// wrong in student code ends this process and nothing else.
class Host {
public:
    explicit Host(SubjectFiles files) : files_(std::move(files)) {}

    /// Serves requests from `descriptor` until the other end closes it.
    [[noreturn]] void serve(int descriptor);

private:
    protocol::Answer perform(const protocol::Request& request);
    protocol::Bytes call(const protocol::Request& request);
    protocol::Bytes draw(const protocol::Request& request);
    protocol::Answer drawFrame(const protocol::Request& request);
    protocol::Bytes describeGraphics();
    void load();
    void needContext(int width, int height);

    SubjectFiles files_;
    Harness harness_;
    std::unique_ptr<cg::Context> context_;
    bool loaded_ = false;
    std::vector<std::string> shaderTodos_;  ///< that the census of this request found
};

}  // namespace runner
