#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Files.h"
#include "Process.h"

namespace grader {

struct Limits {
    int cpuSeconds = 20;
    int memoryMib = 1024;  ///< of address space; 0: no limit
    int processes = 64;
    int fileMib = 256;
    int openFiles = 128;
};

/// What a confined program may see and use. A folder has the same path inside as outside.
struct Confinement {
    std::vector<fs::path> readable;
    std::vector<fs::path> writable;
    fs::path workingFolder;
    /// Names of the system's programs that it needs, beside libraries. Absent: it compiles, and
    /// needs the whole system.
    std::optional<std::vector<std::string>> programs;
    std::vector<std::string> environment;  ///< "NAME=VALUE", beside the few that all programs see
    unsigned user = 0;  ///< whom root becomes before it starts the program; see JobUser
    fs::path cgroup;    ///< which it enters before that; see Cgroup. Empty: none
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

    /// Whether a program sees no file but those that its confinement names, and the system's.
    virtual bool hidesFiles() const = 0;

    /// The command that runs `command` confined. Descriptors are inherited.
    virtual std::vector<std::string> confine(Confinement confinement,
                                             const std::vector<std::string>& command) const = 0;
};

/// Bubblewrap: namespaces of its own for everything, a read-only system, no network, no
/// capabilities. Started by root it first becomes an unprivileged user *outside* the namespace.
/// `confine`: our program with the first and the last step into a sandbox, see grader/confine.
std::unique_ptr<Sandbox> makeBubblewrap(const fs::path& confine);

/// A plain process with the same limits and filter; as root, another user. Where the kernel has
/// Landlock, it opens no file but those that its confinement names, and the system's; else it can
/// read what that user can. It sees other processes, and names of files.
std::unique_ptr<Sandbox> makePlainProcess(const fs::path& confine);

/// How long a sandbox may take to start: a crowded machine must not pass for one without any.
inline constexpr double kSandboxPatience = 60.0;

/// The limit of memory for a program of ours. A sanitizer reserves terabytes of addresses, so with
/// one there is no limit.
int memoryForOwn(int mib);

struct SandboxWish {
    bool none = false;       ///< --no-sandbox: a plain process, whatever the machine has
    bool strangers = false;  ///< other people's code is run, and nobody watches
    std::vector<fs::path> secrets = {};  ///< which that code must not read
};

/// Bubblewrap where it works, else a plain process. Throws Error where strangers' code would run as
/// the grader's own user, unless none was wished for, and where it could read a secret because that
/// lies among the system's own files.
std::unique_ptr<Sandbox> chooseSandbox(const fs::path& confine, SandboxWish wish = {});

/// Whether it was not the command that failed, but what was to confine it, before it began.
bool sandboxFailed(const ProcessResult& result);

/// Whether a CI system runs this: it sets CI, to anything but "false".
bool runsInCi();

/// The user that the programs of one job run as when the grader was started by root: one without a
/// name, whom no other job on this machine has at the same time, so that the limits and files of
/// neighbours are apart. Otherwise the grader's own. Whatever of that user still runs is killed,
/// and what it left in the system's temporary folders removed, at the end and before another job
/// gets it: the grader may have been killed meanwhile. Throws Error when all are taken.
class JobUser {
public:
    JobUser();
    ~JobUser();
    JobUser(const JobUser&) = delete;
    JobUser& operator=(const JobUser&) = delete;
    unsigned id() const { return id_; }

private:
    unsigned id_;
    int lock_ = -1;
};

/// Hands a work folder to a job's user when the grader is root: readable, or its own.
void shareWithSandbox(const fs::path& folder, unsigned user, bool writable);

}  // namespace grader
