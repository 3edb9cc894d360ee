#pragma once

#include <vector>

#include "Files.h"

namespace grader {

/// What the build wrote down for the grader: where things are, and how a student's code is
/// compiled. Read from toolchain.json beside the program.
struct Toolchain {
    fs::path root;   ///< of the repository
    fs::path build;  ///< of the build folder
    fs::path kit;    ///< what a sandbox may see of ours: headers, prelude, library, runner
    std::string kitFingerprint;  ///< another one means: compile anew
    fs::path cache;              ///< compiled objects and decoded references
    std::string compiler;
    std::string compilerVersion;
    std::string glmVersion;
    std::string version;  ///< of the grader
    std::vector<std::string> compileFlags;
    std::vector<std::string> linkFlags;

    fs::path judge(const std::string& assignment) const {
        return build / "judges" / (assignment + "_tests");
    }
    fs::path runner() const { return kit / "bin/runner"; }
    fs::path confine() const { return kit / "bin/confine"; }
    fs::path unpack() const { return kit / "bin/unpack"; }

    /// Throws Error when the file is missing or not what the build writes.
    static Toolchain load();
};

/// The processor's name for itself; "unknown" where it has none.
std::string cpuModel();

/// Changes whenever a file of the kit that a subject is built from does.
std::string fingerprintOf(const fs::path& kit);

/// The kit where the sandbox's user can reach it. Root's own folders are often closed to others;
/// then the kit is copied, once for each build of it, to /var/cache, which only root can write.
fs::path reachableKit(const fs::path& kit);

}  // namespace grader
