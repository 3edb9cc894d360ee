#include "Cgroup.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <vector>

#include "Error.h"
#include "subject/EndAllIn.h"

namespace grader {

namespace {

constexpr const char* kHomePrefix = "course-";
constexpr const char* kLeaf = "graders";  // where processes move that stand in the way
constexpr const char* kControllers[] = {"memory", "pids"};

std::vector<std::string> wordsIn(const fs::path& path) {
    std::ifstream file(path);
    return {std::istream_iterator<std::string>(file), {}};
}

/// Control files take a value with one write. False with errno where the kernel refuses it.
bool set(const fs::path& file, const std::string& value) {
    errno = 0;
    std::ofstream out(file);
    out << value << std::flush;
    return static_cast<bool>(out);
}

bool hasControllers(const fs::path& list) {
    const auto words = wordsIn(list);
    return std::all_of(std::begin(kControllers), std::end(kControllers), [&](const char* each) {
        return std::find(words.begin(), words.end(), each) != words.end();
    });
}

bool handsDown(const fs::path& cgroup) {
    return hasControllers(cgroup / "cgroup.subtree_control");
}

/// Whether children can be made, and processes brought to them.
bool isWritable(const fs::path& cgroup) {
    return access(cgroup.c_str(), W_OK) == 0 &&
           access((cgroup / "cgroup.procs").c_str(), W_OK) == 0;
}

bool hasMemoryLimit(const fs::path& cgroup) {
    const auto limit = wordsIn(cgroup / "memory.max");
    return !limit.empty() && limit.front() != "max";
}

/// The real root, and it alone, may have processes and children with controllers.
bool isRootOfAll(const fs::path& cgroup) {
    return !fs::exists(cgroup / "cgroup.type");
}

// ---- Where this process is

/// A path in mountinfo writes a space as \040.
std::string unescaped(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\' || i + 3 >= text.size()) {
            plain += text[i];
            continue;
        }
        plain += static_cast<char>(std::stoi(text.substr(i + 1, 3), nullptr, 8));
        i += 3;
    }
    return plain;
}

struct Place {
    fs::path top;  ///< the mount: the topmost cgroup that can be seen
    fs::path own;  ///< of this process
};

/// The part of `path` below `base`, both cgroups; nothing where it is not below it.
std::optional<std::string> below(const std::string& base, const std::string& path) {
    if (base == "/")
        return path.substr(1);
    if (path == base)
        return "";
    if (path.starts_with(base + "/"))
        return path.substr(base.size() + 1);
    return std::nullopt;
}

/// proc(5): ID PARENT DEVICE ROOT POINT OPTIONS… - TYPE SOURCE OPTIONS.
std::optional<Place> whereWeAre(const fs::path& root) {
    std::string own;
    std::ifstream memberships(root / "proc/self/cgroup");
    for (std::string line; std::getline(memberships, line);)
        if (line.starts_with("0::/"))
            own = line.substr(3);
    if (own.empty() || own.starts_with("/.."))
        return std::nullopt;
    std::ifstream mounts(root / "proc/self/mountinfo");
    for (std::string line; std::getline(mounts, line);) {
        std::istringstream fields(line);
        const std::vector<std::string> words{std::istream_iterator<std::string>(fields), {}};
        const auto dash = std::find(words.begin(), words.end(), "-");
        if (words.size() < 5 || words.end() - dash < 2 || dash[1] != "cgroup2")
            continue;
        const fs::path top = root / fs::path(unescaped(words[4])).relative_path();
        const auto inside = below(unescaped(words[3]), own);
        if (inside && fs::is_directory(top / *inside))
            return Place{top, inside->empty() ? top : top / *inside};
    }
    return std::nullopt;
}

// ---- Whose a process is

/// 0 where there is none, or it cannot be seen.
pid_t parentOf(pid_t process, const fs::path& root) {
    std::ifstream file(root / "proc" / std::to_string(process) / "status");
    for (std::string word; file >> word;)
        if (word == "PPid:" && file >> word)
            return std::atoi(word.c_str());
    return 0;
}

bool descends(pid_t process, pid_t from, const fs::path& root) {
    for (; process > 0; process = parentOf(process, root))
        if (process == from)
            return true;
    return false;
}

// ---- Making room

std::string because() {
    return errno == 0 ? "" : fmt::format(": {}", std::strerror(errno));
}

/// Lets the own cgroup hand its controllers to children. Why that cannot be; empty when it is done.
std::string openUp(const Place& place, const fs::path& root) {
    const fs::path& own = place.own;
    if (!hasControllers(own / "cgroup.controllers"))
        return fmt::format("{} has no controllers of memory and pids", own.string());
    if (!isWritable(own))
        return fmt::format("{} is not ours to write to", own.string());
    if (!isRootOfAll(own)) {
        const auto processes = wordsIn(own / "cgroup.procs");
        for (const std::string& each : processes) {
            const auto process = static_cast<pid_t>(std::atoi(each.c_str()));
            if (!descends(process, getpid(), root) &&
                !(own == place.top && process > 0 && descends(getpid(), process, root)))
                return fmt::format("{} has processes of others", own.string());
        }
        std::error_code shows;  // in what follows
        fs::create_directory(own / kLeaf, shows);
        for (const std::string& each : processes)
            if (!set(own / kLeaf / "cgroup.procs", each))
                return fmt::format("{} cannot be emptied{}", own.string(), because());
    }
    if (!set(own / "cgroup.subtree_control", "+memory +pids"))
        return fmt::format("{} hands no controllers down{}", own.string(), because());
    return "";
}

/// A cgroup goes once its processes are gone. What stays is removed by the next grader.
void removeCgroup(const fs::path& cgroup) {
    constexpr int kMostTries = 100;
    for (int i = 0; i < kMostTries && rmdir(cgroup.c_str()) != 0 && errno == EBUSY; ++i) {
        if (i == 0)
            judge::endAllIn(cgroup);
        usleep(1000);
    }
}

void removeHome(const fs::path& home) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(home, none))
        if (entry.is_directory(none))
            removeCgroup(entry.path());
    removeCgroup(home);
}

void removeAbandonedHomes(const fs::path& place) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(place, none)) {
        if (!entry.path().filename().string().starts_with(kHomePrefix))
            continue;
        const int lock = open(entry.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) == 0)
            removeHome(entry.path());
        if (lock >= 0)
            close(lock);
    }
}

/// Whether a process can be brought into a cgroup: tried, since much can be in the way.
bool letsIn(const fs::path& cgroup) {
    const int file = open((cgroup / "cgroup.procs").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    const pid_t child = file < 0 ? -1 : fork();
    if (child == 0)
        _exit(write(file, "0", 1) == 1 ? 0 : 1);
    int status = 1;
    if (child > 0)
        waitpid(child, &status, 0);
    if (file >= 0)
        close(file);
    return status == 0;
}

}  // namespace

const CgroupHome& CgroupHome::ours() {
    static const CgroupHome home;
    return home;
}

CgroupHome::CgroupHome(const fs::path& root) : owner_(getpid()) {
    const auto here = whereWeAre(root);
    if (!here || !fs::exists(here->top / "cgroup.controllers")) {
        found_ = "no cgroup v2 is mounted, or this process is in none";
        remedy_ = "start the kernel with systemd.unified_cgroup_hierarchy=1";
        return;
    }
    remedy_ =
        hasControllers(here->top / "cgroup.controllers")
            ? "systemd-run --user --scope -p Delegate=yes ./grade …; a container must let its "
              "root write to its own /sys/fs/cgroup"
            : "start the kernel with systemd.unified_cgroup_hierarchy=1: cgroup v1 has the "
              "controllers";
    // Where a grader before us moved us (or what we were started from) is no place to go on from.
    const fs::path& own = here->own;
    const bool moved = own.filename() == kLeaf && own != here->top && handsDown(own.parent_path());
    bool opened = false;
    if (!moved && !handsDown(own)) {
        found_ = openUp(*here, root);
        opened = found_.empty();
    }
    for (fs::path place = own;; place = place.parent_path()) {
        const bool ready = (opened && place == own) || handsDown(place);
        if (ready && isWritable(place) && settleIn(place)) {
            found_.clear();
            remedy_.clear();
            return;
        }
        if (found_.empty())
            found_ = fmt::format("{} is not ours to write to", place.string());
        if (place == here->top)
            return;
        if (hasMemoryLimit(place)) {
            found_ += fmt::format("; {} has a limit of memory, and is not left", place.string());
            return;
        }
    }
}

bool CgroupHome::settleIn(const fs::path& place) {
    removeAbandonedHomes(place);
    std::string name = (place / (kHomePrefix + std::string("XXXXXX"))).string();
    // Between the folder and its lock, another grader may take it for an abandoned one.
    for (int i = 0; i < 10 && lock_ < 0; ++i) {
        name.replace(name.size() - 6, 6, "XXXXXX");
        if (!mkdtemp(name.data()))
            break;
        lock_ = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (lock_ >= 0 && (flock(lock_, LOCK_EX) != 0 || !fs::exists(name))) {
            close(lock_);
            lock_ = -1;
        }
    }
    if (lock_ < 0) {
        found_ = fmt::format("no cgroup can be made in {}{}", place.string(), because());
        return false;
    }
    folder_ = name;
    try {
        if (!set(folder_ / "cgroup.subtree_control", "+memory +pids"))
            throw Error("{} hands no controllers down{}", name, because());
        const Cgroup tried({64, 8}, *this);
        if (letsIn(tried.folder()))
            return true;
        found_ = fmt::format("no process can be brought to a cgroup in {}", place.string());
    } catch (const Error& error) {
        found_ = error.what();
    }
    removeHome(folder_);
    folder_.clear();
    close(lock_);
    lock_ = -1;
    return false;
}

CgroupHome::~CgroupHome() {
    if (folder_.empty() || getpid() != owner_)
        return;
    removeHome(folder_);
    close(lock_);
}

Cgroup::Cgroup(const CgroupLimits& limits, const CgroupHome& home) {
    if (home.folder().empty())
        return;
    // A grading that was killed (--watch) may have left its own, with counters that are not ours.
    folder_ = home.folder() / fmt::format("{}-{}", getpid(), home.next());
    std::error_code failed;
    fs::create_directory(folder_, failed);
    if (failed)
        throw Error("the cgroup {} cannot be made: {}", folder_.string(), failed.message());
    const auto require = [&](const char* file, const std::string& value) {
        if (set(folder_ / file, value))
            return;
        const std::string why = because();
        removeCgroup(folder_);
        throw Error("the limit {} of the cgroup {} cannot be set to {}{}", file, folder_.string(),
                    value, why);
    };
    if (limits.memoryMib > 0) {
        require("memory.max", fmt::format("{}M", limits.memoryMib));
        set(folder_ / "memory.swap.max", "0");  // not there without swap
        if (limits.endTogether)
            set(folder_ / "memory.oom.group", "1");  // not there before Linux 4.19
    }
    if (limits.processes > 0)
        require("pids.max", std::to_string(limits.processes));
}

Cgroup::~Cgroup() {
    if (!folder_.empty())
        removeCgroup(folder_);
}

}  // namespace grader
