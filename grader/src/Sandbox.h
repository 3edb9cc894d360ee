#pragma once

#include <memory>
#include <string>
#include <vector>

#include "Files.h"

namespace grader {

struct Limits {
    int cpuSeconds = 20;
    int memoryMib = 1024;
    int processes = 64;
    int fileMib = 256;
    int openFiles = 128;
};

/// What a confined program may see and use. A folder has the same path inside as outside.
struct Confinement {
    std::vector<fs::path> readable;
    std::vector<fs::path> writable;
    fs::path workingFolder;
    std::vector<std::string> environment;  ///< "NAME=VALUE", beside the few that all programs see
    Limits limits;
};

/// A way to run a stranger's program. An interface, because tests must not depend on what the
/// machine allows.
class Sandbox {
public:
    virtual ~Sandbox() = default;

    /// What the result document calls it: "bubblewrap", "plain".
    virtual std::string name() const = 0;

    /// One sentence on what it does not protect from; empty when there is nothing to say.
    virtual std::string weakness() const = 0;

    /// The command that runs `command` confined. Descriptors are inherited.
    virtual std::vector<std::string> confine(const Confinement& confinement,
                                             const std::vector<std::string>& command) const = 0;
};

/// Bubblewrap: namespaces of its own for everything, a read-only system, no network, no
/// capabilities. Started by root it first becomes an unprivileged user *outside* the namespace.
std::unique_ptr<Sandbox> makeBubblewrap();

/// A plain process with limits; as root, another user. It can read what that user can read.
std::unique_ptr<Sandbox> makePlainProcess();

/// Bubblewrap where it works, else a plain process.
std::unique_ptr<Sandbox> chooseSandbox();

/// The user that confined programs run as when the grader was started by root.
inline constexpr unsigned kSandboxUser = 65534;

/// Hands a work folder to the confined user when the grader is root: readable, or its own.
void shareWithSandbox(const fs::path& folder, bool writable);

}  // namespace grader
