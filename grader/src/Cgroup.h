#pragma once

#include <sys/types.h>

#include <atomic>
#include <string>

#include "Files.h"

namespace grader {

/// Where the kernel lets this grader limit what several processes use in sum: a folder in the
/// hierarchy of cgroup v2, with a cgroup in it for each program that is run in a sandbox.
///
/// Theory of operation. It goes up from the cgroup that this process is in, and takes the first one
/// that may be written to and hands the controllers `memory` and `pids` to its children. The own
/// one is made to hand them down, if need be; but no cgroup with processes can, so what is in there
/// moves to a leaf, and only if all of it is ours: this process and what it started; in the topmost
/// cgroup of a container, what it was started from, too. A cgroup with a limit of memory is never
/// left: it was meant to hold. There, a folder `course-XXXXXX` is made and locked as long as this
/// process lives. Those that nobody has locked were left by graders that were killed, and are
/// removed with all that runs in them.
class CgroupHome {
public:
    /// The one of this process; the first call looks for it and should come before there are other
    /// threads and children.
    static const CgroupHome& ours();

    /// `root`: the folder that holds /proc and /sys.
    explicit CgroupHome(const fs::path& root = "/");
    ~CgroupHome();
    CgroupHome(const CgroupHome&) = delete;
    CgroupHome& operator=(const CgroupHome&) = delete;

    /// Empty where there is none; then all is as if there were no cgroups.
    const fs::path& folder() const { return folder_; }

    /// Why there is none, and how to get one.
    const std::string& found() const { return found_; }
    const std::string& remedy() const { return remedy_; }

    /// A number for each cgroup that is made here.
    unsigned next() const { return next_++; }

private:
    bool settleIn(const fs::path& place);

    fs::path folder_;
    std::string found_, remedy_;
    int lock_ = -1;
    pid_t owner_ = -1;  ///< a forked child does not remove what is its parent's
    mutable std::atomic<unsigned> next_ = 1;
};

/// What the processes in one cgroup may use together. Zero: no limit.
struct CgroupLimits {
    int memoryMib = 0;  ///< of processes, of files in memory, and of the kernel for them; no swap
    int processes = 0;  ///< each thread counts
    bool endTogether = true;  ///< when memory runs out, all of it ends; else the largest process
};

/// A cgroup for one program, which `confine enter` puts in there; at the end all that is left in it
/// is killed. Without a home there is none, and `folder` is empty. Throws Error when it cannot be
/// made although there is a home.
class Cgroup {
public:
    explicit Cgroup(const CgroupLimits& limits, const CgroupHome& home = CgroupHome::ours());
    ~Cgroup();
    Cgroup(const Cgroup&) = delete;
    Cgroup& operator=(const Cgroup&) = delete;
    const fs::path& folder() const { return folder_; }

private:
    fs::path folder_;
};

}  // namespace grader
