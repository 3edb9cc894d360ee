#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <vector>

namespace runner {

/// What processes use together: what no limit of a single process sees.
struct Usage {
    std::size_t memoryBytes = 0;  ///< resident; what they share counts once for each
    std::size_t threads = 0;
};

/// Of all that this process started or inherited (main.cpp: subreaper), but for some of its
/// children and what they started.
Usage usageWithout(const std::vector<pid_t>& spared);

/// Processes whose parent this one is, or became when theirs died.
std::vector<pid_t> childrenOfThisProcess();

/// Descriptors that a process has open; 0 where that cannot be seen.
std::size_t openFilesOf(pid_t process);

/// How long a process's first thread has waited for a processor while it could have run; nothing
/// where the kernel does not tell.
std::chrono::nanoseconds waitedForProcessor(pid_t process);

/// Whether its first thread is waiting, this moment, for what no signal interrupts: as a rule a
/// disk, which may hold the page that it needs next.
bool waitsForDisk(pid_t process);

/// What this process may use; its children inherit it.
struct Allowance {
    std::size_t memoryBytes, threads, fileBytes, openFiles, cpuSeconds;
};
Allowance allowance();

}  // namespace runner
