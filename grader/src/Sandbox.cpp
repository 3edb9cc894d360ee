#include "Sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "Cgroup.h"
#include "Error.h"
#include "Process.h"
#include "SystemFiles.h"
#include "confine/FileRules.h"

namespace grader {

namespace {

using Command = std::vector<std::string>;

constexpr unsigned kNobody = 65534;  // as whom a program sees itself in its namespace

constexpr const char* kTmpfsBytes = "67108864";  // of /tmp, and as much of /dev/shm

/// Users without a name; Debian keeps these numbers free.
constexpr unsigned kFirstJobUser = 65000, kJobUsers = 500;
constexpr unsigned kEnder = kFirstJobUser + kJobUsers;  // nothing runs as this one

void append(Command& command, const Command& more) {
    command.insert(command.end(), more.begin(), more.end());
}

/// Our program's first step: the only variables that a confined program sees, its folder, its
/// cgroup where there is one, and the job's user where the grader is root.
Command enterCommand(const fs::path& confine, const fs::path& folder,
                     const Confinement& confinement) {
    if (geteuid() == 0 && confinement.user == 0)
        throw Error("a program was about to run as root in a sandbox");
    Command command = {confine.string(),
                       "enter",
                       std::to_string(confinement.user),
                       folder.string(),
                       confinement.cgroup.empty() ? "-" : confinement.cgroup.string(),
                       "PATH=/usr/bin:/bin",
                       "LANG=C.UTF-8",
                       "HOME=/nonexistent",
                       "TMPDIR=/tmp"};
    append(command, confinement.environment);
    command.push_back("--");
    return command;
}

/// Threads that the user runs outside any sandbox; a plain process shares their limit.
int threadsOfThisUser() {
    int threads = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        struct stat status {};
        std::error_code ignored;
        if (::stat(entry.path().c_str(), &status) != 0 || status.st_uid != getuid())
            continue;
        for ([[maybe_unused]] const auto& each :
             fs::directory_iterator(entry.path() / "task", ignored))
            ++threads;
    }
    return threads;
}

/// Its last step, which sets the limits and the filter.
Command limitCommand(const fs::path& confine, const Limits& limits, int otherProcesses) {
    Command command = {confine.string(),
                       "limit",
                       fmt::format("cpu={}", limits.cpuSeconds),
                       fmt::format("processes={}", limits.processes + otherProcesses),
                       fmt::format("file={}", limits.fileMib),
                       fmt::format("files={}", limits.openFiles)};
    if (limits.memoryMib > 0)
        command.push_back(fmt::format("memory={}", limits.memoryMib));
    command.push_back("--");
    return command;
}

std::vector<fs::path> ofTheSystem(const Confinement& confinement) {
    return confinement.programs ? librariesAnd(*confinement.programs) : wholeSystem();
}

class Bubblewrap : public Sandbox {
public:
    explicit Bubblewrap(fs::path confine) : confine_(std::move(confine)) {}
    std::string name() const override { return "bubblewrap"; }
    bool hidesFiles() const override { return true; }
    std::string weakness() const override { return ""; }

    Command confine(Confinement confinement, const Command& command) const override {
        const std::string id = std::to_string(kNobody);
        Command all = enterCommand(confine_, "/", confinement);
        append(all, {"bwrap",
                     "--unshare-all",
                     "--unshare-user",
                     "--uid",
                     id,
                     "--gid",
                     id,
                     "--as-pid-1",
                     "--die-with-parent",
                     "--new-session",
                     "--cap-drop",
                     "ALL",
                     "--hostname",
                     "sandbox",
                     "--proc",
                     "/proc",
                     "--dev",
                     "/dev",
                     "--size",
                     kTmpfsBytes,
                     "--tmpfs",
                     "/dev/shm",
                     "--remount-ro",
                     "/dev",
                     "--size",
                     kTmpfsBytes,
                     "--tmpfs",
                     "/tmp"});
        for (const fs::path& each : ofTheSystem(confinement))
            append(all, {"--ro-bind", fs::canonical(each).string(), each.string()});
        for (const fs::path& link : systemLinks())
            append(all, {"--symlink", fs::read_symlink(link).string(), link.string()});
        for (const fs::path& folder : confinement.readable)
            append(all, {"--ro-bind", folder.string(), folder.string()});
        for (const fs::path& folder : confinement.writable)
            append(all, {"--bind", folder.string(), folder.string()});
        append(all, {"--ro-bind", confine_.string(), confine_.string()});
        append(all, {"--remount-ro", "/", "--chdir", confinement.workingFolder.string(), "--"});
        append(all, limitCommand(confine_, confinement.limits, 0));
        append(all, command);
        return all;
    }

private:
    const fs::path confine_;
};

class PlainProcess : public Sandbox {
public:
    explicit PlainProcess(fs::path confine) : confine_(std::move(confine)) {}
    std::string name() const override { return "plain"; }
    bool hidesFiles() const override {
        static const bool can = confine::canHoldToFiles();
        return can;
    }
    std::string weakness() const override {
        return std::string(
                   "without bubblewrap, the submission ran as a plain process with limits, ") +
               (geteuid() != 0 ? "so grade only code that you trust"
                : hidesFiles()
                    ? "as a user of its own, who sees which files and processes there are"
                    : "as a user of its own, who can read what others may");
    }

    Command confine(Confinement confinement, const Command& command) const override {
        static const int others = geteuid() == 0 ? 0 : threadsOfThisUser();
        Command limits = limitCommand(confine_, confinement.limits, others);
        if (hidesFiles()) {
            const auto dashes = limits.end() - 1;
            Command files = {"read=/proc"};
            for (const auto& list : {ofTheSystem(confinement), confinement.readable})
                for (const fs::path& each : list)
                    files.push_back("read=" + each.string());
            for (const fs::path& each : confinement.writable)
                files.push_back("write=" + each.string());
            limits.insert(dashes, files.begin(), files.end());
            // The system's own folder for what is temporary belongs to all.
            if (!confinement.writable.empty())
                confinement.environment.push_back("TMPDIR=" +
                                                  confinement.writable.front().string());
        }
        Command all = enterCommand(confine_, confinement.workingFolder, confinement);
        append(all, limits);
        append(all, command);
        return all;
    }

private:
    const fs::path confine_;
};

}  // namespace

std::unique_ptr<Sandbox> makeBubblewrap(const fs::path& confine) {
    return std::make_unique<Bubblewrap>(confine);
}
std::unique_ptr<Sandbox> makePlainProcess(const fs::path& confine) {
    return std::make_unique<PlainProcess>(confine);
}

int memoryForOwn([[maybe_unused]] int mib) {
#ifdef __SANITIZE_ADDRESS__
    return 0;
#else
    return mib;
#endif
}

bool sandboxFailed(const ProcessResult& result) {
    return result.output.starts_with("bwrap: ") || result.output.starts_with("confine: ");
}

bool runsInCi() {
    const char* value = std::getenv("CI");
    return value && *value && std::string(value) != "false";
}

std::unique_ptr<Sandbox> chooseSandbox(const fs::path& confine, SandboxWish wish) {
    CgroupHome::ours();  // while there are no threads and children
    if (wish.strangers)
        for (const fs::path& each : wish.secrets)
            refuseAmongSystemFiles(each);
    if (wish.none)
        return makePlainProcess(confine);
    auto bubblewrap = makeBubblewrap(confine);
    const JobUser user;
    Confinement nothing;
    nothing.workingFolder = "/";
    nothing.user = user.id();
    if (run(bubblewrap->confine(nothing, {"true"}), kSandboxPatience).succeeded())
        return bubblewrap;
    if (wish.strangers && geteuid() != 0)
        throw Error(
            "there is no sandbox on this machine, and a batch or a CI system runs other people's "
            "code: ./grade doctor says how to get one; start the grader as root; or insist with "
            "--no-sandbox");
    return makePlainProcess(confine);
}

namespace {

/// A process that may do what the user may kills all that it may. Only its effective identity is
/// the user's: whoever is to be killed may not kill it first. False when that could not be done.
bool endAllOf(unsigned user) {
    const pid_t pid = fork();
    if (pid == 0) {
        // The kernel's own call: that of the C library tells other threads, and there are none.
        const bool ended = syscall(SYS_setresuid, kEnder, user, kEnder) == 0 &&
                           (kill(-1, SIGKILL) == 0 || errno == ESRCH);
        _exit(ended ? 0 : 1);
    }
    int status = 0;
    while (pid > 0 && waitpid(pid, &status, 0) < 0)
        if (errno != EINTR)
            return false;
    return pid > 0 && status == 0;
}

/// What a user whom nothing held to its own files may have left where everybody may write.
void removeFilesOf(unsigned user) {
    for (const char* folder : {"/tmp", "/var/tmp", "/dev/shm", "/dev/mqueue", "/run/lock"})
        for (const fs::path& each : entriesOf(folder)) {
            struct stat status {};
            std::error_code stays;
            if (lstat(each.c_str(), &status) == 0 && status.st_uid == user)
                fs::remove_all(each, stays);
        }
}

/// Ends and removes what is left of a user. False when some of it may still run.
bool cleanedUpAfter(unsigned user) {
    if (!endAllOf(user))
        return false;
    removeFilesOf(user);
    return true;
}

}  // namespace

JobUser::JobUser() : id_(geteuid()) {
    if (id_ != 0)
        return;
    const fs::path home = "/var/cache/graphics-course/users";
    fs::create_directories(home);
    fs::permissions(home, fs::perms::owner_all);
    // Not all jobs ask for the first one first, nor does one follow the other at once.
    static std::atomic<unsigned> next{static_cast<unsigned>(getpid())};
    const unsigned start = next++ % kJobUsers;
    for (unsigned i = 0; i < kJobUsers; ++i) {
        const unsigned id = kFirstJobUser + (start + i) % kJobUsers;
        const int file =
            open((home / std::to_string(id)).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (file < 0)
            throw Error("{} cannot be written: {}", home.string(), std::strerror(errno));
        // Its file is empty, unless the last job's grader was killed before it could clean up.
        if (flock(file, LOCK_EX | LOCK_NB) == 0 &&
            (lseek(file, 0, SEEK_END) == 0 || cleanedUpAfter(id)) && write(file, "taken", 5) == 5) {
            id_ = id;
            lock_ = file;
            return;
        }
        close(file);
    }
    throw Error("all {} users for jobs are taken: wait until other grading has ended", kJobUsers);
}

JobUser::~JobUser() {
    if (lock_ < 0)
        return;
    const bool clean = cleanedUpAfter(id_) && ftruncate(lock_, 0) == 0;
    (void)clean;  // if not, the next job does it
    close(lock_);
}

void shareWithSandbox(const fs::path& folder, unsigned user, bool writable) {
    if (geteuid() != 0)
        return;
    const auto change = [&](const fs::path& path) {
        if (lchown(path.c_str(), writable ? user : 0, user) != 0)
            throw Error("{} cannot be given to the sandbox's user", path.string());
    };
    change(folder);
    chmod(folder.c_str(), writable ? 0700 : 0750);
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        change(entry.path());
        if (!entry.is_symlink())
            chmod(entry.path().c_str(), entry.is_directory() ? 0750 : 0640);
    }
}

}  // namespace grader
