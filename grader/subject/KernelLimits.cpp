#include "subject/KernelLimits.h"

#include <fstream>

namespace judge {

namespace {

/// Of a file with a name and a number in each line.
unsigned long numberIn(const std::string& file, const std::string& name) {
    std::ifstream lines(file);
    std::string each;
    for (unsigned long number = 0; lines >> each >> number;)
        if (each == name)
            return number;
    return 0;
}

}  // namespace

Interventions interventionsIn(const std::string& cgroup) {
    if (cgroup.empty())
        return {};
    const std::string memory = cgroup + "/memory.events";
    // `oom`: this cgroup's own limit was reached. `oom_kill` counts whoever was killed in it.
    const bool own = numberIn(memory, "oom") > 0;
    return {own ? numberIn(memory, "oom_kill") : 0, numberIn(cgroup + "/pids.events", "max")};
}

}  // namespace judge
