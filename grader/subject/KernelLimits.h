#pragma once

#include <string>

namespace judge {

/// A cgroup that a runner is in with all that it starts, and what a student is told when the kernel
/// steps in there.
struct KernelLimits {
    std::string cgroup;  ///< its folder; empty where there is none
    int memoryMib = 0;   ///< what the code of a submission may have
    int processes = 0;   ///< and how many it may start
};

/// How often the kernel stepped in because a cgroup had reached a limit of its own; a machine or an
/// enclosing cgroup without memory does not count.
struct Interventions {
    unsigned long memory = 0;     ///< processes that were killed
    unsigned long processes = 0;  ///< forks that were refused
};

/// Since the cgroup was made. Nothing where there is no such folder.
Interventions interventionsIn(const std::string& cgroup);

}  // namespace judge
