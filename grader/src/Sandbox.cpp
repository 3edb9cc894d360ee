#include "Sandbox.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "Error.h"
#include "Process.h"

namespace grader {

namespace {

using Command = std::vector<std::string>;

void append(Command& command, const Command& more) {
    command.insert(command.end(), more.begin(), more.end());
}

/// The only variables that a confined program sees.
Command environment(const Confinement& confinement) {
    Command variables = {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "HOME=/nonexistent", "TMPDIR=/tmp"};
    append(variables, confinement.environment);
    return variables;
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

Command limitsOf(const Limits& limits, int otherProcesses) {
    const long long mib = 1024 * 1024;
    return {"prlimit",
            fmt::format("--cpu={}", limits.cpuSeconds),
            fmt::format("--as={}", limits.memoryMib * mib),
            fmt::format("--nproc={}", limits.processes + otherProcesses),
            fmt::format("--fsize={}", limits.fileMib * mib),
            fmt::format("--nofile={}", limits.openFiles),
            "--core=0",
            "--"};
}

Command becomeUnprivileged() {
    if (geteuid() != 0)
        return {};
    const std::string id = std::to_string(kSandboxUser);
    return {"setpriv", "--reuid", id, "--regid", id, "--clear-groups"};
}

class Bubblewrap : public Sandbox {
public:
    std::string name() const override { return "bubblewrap"; }
    std::string weakness() const override { return ""; }

    Command confine(const Confinement& confinement, const Command& command) const override {
        const std::string id = std::to_string(kSandboxUser);
        Command all = {"env", "-i"};
        append(all, environment(confinement));
        append(all, becomeUnprivileged());
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
                     "67108864",
                     "--tmpfs",
                     "/tmp",
                     "--ro-bind",
                     "/usr",
                     "/usr"});
        for (const char* name : {"/bin", "/lib", "/lib64"})
            if (fs::is_symlink(name))
                append(all, {"--symlink", fs::read_symlink(name).string(), name});
            else if (fs::exists(name))
                append(all, {"--ro-bind", name, name});
        append(all, {"--ro-bind-try", "/etc/ld.so.cache", "/etc/ld.so.cache", "--ro-bind-try",
                     "/etc/alternatives", "/etc/alternatives"});
        for (const fs::path& folder : confinement.readable)
            append(all, {"--ro-bind", folder.string(), folder.string()});
        for (const fs::path& folder : confinement.writable)
            append(all, {"--bind", folder.string(), folder.string()});
        append(all, {"--remount-ro", "/", "--chdir", confinement.workingFolder.string(), "--"});
        append(all, limitsOf(confinement.limits, 0));
        append(all, command);
        return all;
    }
};

class PlainProcess : public Sandbox {
public:
    std::string name() const override { return "plain"; }
    std::string weakness() const override {
        return "bubblewrap does not run on this machine: the submission ran as a plain process "
               "with limits, so grade only code that you trust";
    }

    Command confine(const Confinement& confinement, const Command& command) const override {
        Command all = {"env", "-i", "-C", confinement.workingFolder.string()};
        append(all, environment(confinement));
        append(all, becomeUnprivileged());
        append(all, {"setpriv", "--no-new-privs", "--pdeathsig", "KILL"});
        static const int others = geteuid() == 0 ? 0 : threadsOfThisUser();
        append(all, limitsOf(confinement.limits, others));
        append(all, command);
        return all;
    }
};

}  // namespace

std::unique_ptr<Sandbox> makeBubblewrap() {
    return std::make_unique<Bubblewrap>();
}
std::unique_ptr<Sandbox> makePlainProcess() {
    return std::make_unique<PlainProcess>();
}

std::unique_ptr<Sandbox> chooseSandbox() {
    auto bubblewrap = makeBubblewrap();
    Confinement nothing;
    nothing.workingFolder = "/";
    if (run(bubblewrap->confine(nothing, {"true"}), 5.0).succeeded())
        return bubblewrap;
    return makePlainProcess();
}

void shareWithSandbox(const fs::path& folder, bool writable) {
    if (geteuid() != 0)
        return;
    const auto change = [&](const fs::path& path) {
        if (chown(path.c_str(), writable ? kSandboxUser : 0, kSandboxUser) != 0)
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
