#pragma once

#include "Collect.h"
#include "Sandbox.h"
#include "Toolchain.h"

namespace grader {

struct BuildResult {
    bool ok = false;
    bool fromOutside = false;  ///< not ok, and the reason may be this machine's, not the code's
    std::vector<Diagnostic> diagnostics;  ///< errors first, in the order of the compiler
    fs::path stage;                       ///< the folder with what the subject reads: no sources
    fs::path object;                      ///< the subject, when ok
    unsigned user = 0;                    ///< the job's: whom the subject runs as
};

/// What one submission has to itself while it is graded.
struct Job {
    WorkFolder work;
    JobUser user;
};

/// Builds a stage into one shared object, in the job's folder.
///
/// One compiler call per source file, in the sandbox, in parallel; what the same compiler made of
/// the same text before is taken from the cache. Inherited files are linked from an archive, so
/// that a student's own definition wins. Never runs what it built.
class Builder {
public:
    Builder(const Toolchain& tools, const Sandbox& sandbox) : tools_(tools), sandbox_(sandbox) {}

    BuildResult build(const Stage& stage, const AssignmentLimits& limits, const Job& job) const;

private:
    const Toolchain& tools_;
    const Sandbox& sandbox_;
};

/// The seconds after which a build has ended, whatever is built.
double longestBuild(const AssignmentLimits& limits);

}  // namespace grader
