#include "confine/FileRules.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace confine {

namespace {

/// landlock_ruleset_attr of Linux 6.12; older kernels take the first part of it.
struct Ruleset {
    std::uint64_t files, network, scoped;
};
// Of versions 2, 3 and 5; the headers of Ubuntu 22.04 know version 1.
constexpr std::uint64_t kRefer = 1 << 13, kTruncate = 1 << 14, kDeviceCalls = 1 << 15;
constexpr std::uint64_t kAbstractSockets = 1 << 0, kSignals = 1 << 1;  // of version 6

constexpr std::uint64_t kRead =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kOfFiles = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE |
                                   LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate | kDeviceCalls;

constexpr const char* kDevices[] = {"/dev/null", "/dev/zero", "/dev/full", "/dev/random",
                                    "/dev/urandom"};

int version() {
    const long answer =
        syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return answer > 0 ? static_cast<int>(answer) : 0;
}

/// All ways to reach a file that this version of the kernel tells apart.
std::uint64_t everyAccess(int version) {
    std::uint64_t all = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
    if (version >= 2)
        all |= kRefer;
    if (version >= 3)
        all |= kTruncate;
    if (version >= 5)
        all |= kDeviceCalls;
    return all;
}

class Rules {
public:
    explicit Rules(int version) : every_(everyAccess(version)) {
        const Ruleset all{every_, 0, version >= 6 ? kAbstractSockets | kSignals : 0};
        const std::size_t size = version >= 6 ? sizeof all : sizeof all.files;
        rules_ = static_cast<int>(syscall(SYS_landlock_create_ruleset, &all, size, 0));
        if (rules_ < 0)
            fail("files cannot be hidden");
    }
    ~Rules() { close(rules_); }
    Rules(const Rules&) = delete;
    Rules& operator=(const Rules&) = delete;

    void allowReading(const std::string& path) { allow(path.c_str(), kRead, true); }
    void allowWriting(const std::string& path) { allow(path.c_str(), every_, true); }
    void allowDevice(const char* path) { allow(path, every_, false); }

    void apply() {
        if (syscall(SYS_landlock_restrict_self, rules_, 0) != 0)
            fail("files cannot be hidden");
    }

private:
    [[noreturn]] static void fail(const std::string& what) {
        throw std::runtime_error(what + ": " + std::strerror(errno));
    }

    void allow(const char* path, std::uint64_t access, bool required) {
        const int file = open(path, O_PATH | O_CLOEXEC);
        struct stat status {};
        if (file < 0 || fstat(file, &status) != 0) {
            if (required)
                fail(std::string(path) + " cannot be shown");
            return;
        }
        landlock_path_beneath_attr rule{};
        rule.allowed_access = access & every_ & (S_ISDIR(status.st_mode) ? every_ : kOfFiles);
        rule.parent_fd = file;
        const long added =
            syscall(SYS_landlock_add_rule, rules_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
        close(file);
        if (added != 0)
            fail(std::string(path) + " cannot be shown");
    }

    std::uint64_t every_;
    int rules_;
};

}  // namespace

bool canHoldToFiles() {
    return version() > 0;
}

void holdToFiles(const std::vector<std::string>& readable,
                 const std::vector<std::string>& writable) {
    const int here = version();
    if (here == 0)
        return;
    Rules rules(here);
    for (const char* each : kDevices)
        rules.allowDevice(each);
    for (const std::string& each : readable)
        rules.allowReading(each);
    for (const std::string& each : writable)
        rules.allowWriting(each);
    rules.apply();
}

}  // namespace confine
