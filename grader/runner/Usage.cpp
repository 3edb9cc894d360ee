#include "runner/Usage.h"

#include <dirent.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

namespace runner {

namespace {

struct Process {
    pid_t id = 0, parent = 0;
    char state = '?';
    std::size_t threads = 0, residentPages = 0;
};

/// Reads /proc/ID/stat: a name in parentheses, which may hold anything, then numbers (proc(5)).
Process processOf(pid_t id) {
    std::ifstream file("/proc/" + std::to_string(id) + "/stat");
    std::string line;
    std::getline(file, line);
    const auto end = line.rfind(')');
    if (end == std::string::npos)
        return {};
    std::istringstream fields(line.substr(end + 1));
    constexpr int kState = 3, kParent = 4, kThreads = 20, kResidentPages = 24;
    Process process;
    process.id = id;
    std::string word;
    for (int field = kState; field <= kResidentPages && fields >> word; ++field) {
        const auto number = std::strtoul(word.c_str(), nullptr, 10);
        if (field == kState)
            process.state = word.front();
        else if (field == kParent)
            process.parent = static_cast<pid_t>(number);
        else if (field == kThreads)
            process.threads = number;
        else if (field == kResidentPages)
            process.residentPages = number;
    }
    return process;
}

using Folder = std::unique_ptr<DIR, int (*)(DIR*)>;

/// All that can be seen. The kernel's own lists of children are not in every kernel.
std::vector<Process> allProcesses() {
    std::vector<Process> all;
    const Folder folder(opendir("/proc"), closedir);
    while (const dirent* entry = folder ? readdir(folder.get()) : nullptr)
        if (const auto id = static_cast<pid_t>(std::atoi(entry->d_name)); id > 0)
            all.push_back(processOf(id));
    return all;
}

std::size_t limitOf(int resource) {
    rlimit limit{};
    getrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
    return limit.rlim_cur;
}

}  // namespace

Usage usageWithout(const std::vector<pid_t>& spared) {
    const auto all = allProcesses();
    const auto pageSize = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    Usage usage;
    std::vector<pid_t> parents = {getpid()};
    while (!parents.empty()) {
        const pid_t parent = parents.back();
        parents.pop_back();
        for (const Process& each : all) {
            if (each.parent != parent || each.id == 0 ||
                std::find(spared.begin(), spared.end(), each.id) != spared.end())
                continue;
            usage.memoryBytes += each.residentPages * pageSize;
            usage.threads += each.threads;
            parents.push_back(each.id);
        }
    }
    return usage;
}

std::vector<pid_t> childrenOfThisProcess() {
    std::vector<pid_t> children;
    for (const Process& each : allProcesses())
        if (each.parent == getpid())
            children.push_back(each.id);
    return children;
}

std::size_t openFilesOf(pid_t process) {
    const Folder folder(opendir(("/proc/" + std::to_string(process) + "/fd").c_str()), closedir);
    std::size_t count = 0;
    while (const dirent* entry = folder ? readdir(folder.get()) : nullptr)
        count += entry->d_name[0] != '.';
    return count;
}

std::chrono::nanoseconds waitedForProcessor(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/schedstat");
    long long ran = 0, waited = 0;
    file >> ran >> waited;
    return std::chrono::nanoseconds(waited);
}

bool waitsForDisk(pid_t process) {
    return processOf(process).state == 'D';
}

Allowance allowance() {
    // Without a limit (under a sanitizer), more than anybody needs and less than a machine has.
    constexpr std::size_t kMostMemory = std::size_t(4) << 30;
    const std::size_t memory = limitOf(RLIMIT_AS);
    return {memory == RLIM_INFINITY ? kMostMemory : memory, limitOf(RLIMIT_NPROC),
            limitOf(RLIMIT_FSIZE), limitOf(RLIMIT_NOFILE), limitOf(RLIMIT_CPU)};
}

}  // namespace runner
