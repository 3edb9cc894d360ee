// Tries what a sandbox should not let through and prints what happened, one line per attempt:
// `sandbox_probe ATTEMPT [ARGUMENT]`. Plain system calls, so that little can get in the way.

#include <arpa/inet.h>
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

extern char** environ;

namespace {

void say(const char* what, bool worked) {
    std::printf("%s: %s\n", what, worked ? "yes" : std::strerror(errno));
}

void tryToRead(const char* path) {
    const int file = open(path, O_RDONLY);
    char byte;
    say("read", file >= 0 && read(file, &byte, 1) >= 0);
}

void tryToWrite(const std::string& folder) {
    say("write", open((folder + "/written").c_str(), O_CREAT | O_WRONLY, 0600) >= 0);
}

void tryToConnect(int port) {
    const int out = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_port = htons(static_cast<std::uint16_t>(port));
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    say("connect",
        out >= 0 && connect(out, reinterpret_cast<const sockaddr*>(&here), sizeof here) == 0);
}

/// Children that wait until all have been started.
void forkUpTo(int wanted) {
    std::vector<pid_t> children;
    int failure = 0;
    for (int i = 0; i < wanted && failure == 0; ++i) {
        const pid_t child = fork();
        if (child == 0)
            for (;;)
                pause();
        if (child < 0)
            failure = errno;
        else
            children.push_back(child);
    }
    std::printf("started: %zu\nfailure: %s\n", children.size(),
                failure ? std::strerror(failure) : "none");
    for (const pid_t child : children) {
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
    }
}

void askForMemory(std::size_t mebibytes) {
    void* memory =
        mmap(nullptr, mebibytes << 20, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    say("memory", memory != MAP_FAILED);
}

/// Children that each take a part of it and keep it; no longer than a test may take.
void askForMemoryInMany(std::size_t mebibytes) {
    constexpr std::size_t kChildren = 8;
    const std::size_t bytes = (mebibytes << 20) / kChildren;
    for (std::size_t i = 0; i < kChildren; ++i)
        if (fork() == 0) {
            std::memset(std::malloc(bytes), 1, bytes);
            pause();
        }
    alarm(20);
    pause();
}

void writeLargeFile(const std::string& folder, int mebibytes) {
    signal(SIGXFSZ, SIG_IGN);
    const int file = open((folder + "/large").c_str(), O_CREAT | O_WRONLY, 0600);
    const std::vector<char> block(1 << 20, 'x');
    int written = 0;
    while (written < mebibytes && write(file, block.data(), block.size()) == 1 << 20)
        ++written;
    std::printf("written: %d\n", written);
}

/// System calls that most programs may make elsewhere, with arguments that would do no harm.
void tryCall(const std::string& name) {
    long result = -1;
    std::uint64_t zeros[16] = {};
    iovec nothing{zeros, sizeof zeros};
    if (name == "unshare")
        result = syscall(SYS_unshare, CLONE_NEWUSER);
    else if (name == "mount")
        result = syscall(SYS_mount, "none", "/tmp", "tmpfs", 0, nullptr);
    else if (name == "ptrace")
        result = syscall(SYS_ptrace, 0 /* PTRACE_TRACEME */, 0, 0, 0);
    else if (name == "process_vm_readv")
        result = syscall(SYS_process_vm_readv, getpid(), &nothing, 1, &nothing, 1, 0);
    else if (name == "keyctl")
        result = syscall(SYS_keyctl, 0 /* KEYCTL_GET_KEYRING_ID */, -2, 0);
    else if (name == "bpf")
        result = syscall(SYS_bpf, 0, nullptr, 0);
    else if (name == "io_uring_setup")
        result = syscall(SYS_io_uring_setup, 1, zeros);
    else if (name == "userfaultfd")
        result = syscall(SYS_userfaultfd, 1 /* UFFD_USER_MODE_ONLY */);
    else if (name == "perf_event_open")
        result = syscall(SYS_perf_event_open, zeros, 0, -1, -1, 0);
    else if (name == "clone-newuser")
        result = syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, 0);
    else if (name == "clone3")
        result = syscall(SYS_clone3, zeros, 64);
    else if (name == "setns")
        result = syscall(SYS_setns, -1, 0);
    else if (name == "personality")
        result = syscall(SYS_personality, 0xffffffff);
    else
        errno = ENOENT;
    say(name.c_str(), result >= 0);
}

void trySocket(const std::string& name) {
    const std::pair<const char*, int> families[] = {
        {"unix", AF_UNIX},     {"inet", AF_INET},   {"inet6", AF_INET6}, {"netlink", AF_NETLINK},
        {"packet", AF_PACKET}, {"vsock", AF_VSOCK}, {"alg", AF_ALG}};
    for (const auto& [known, family] : families)
        if (name == known)
            say(known, socket(family, SOCK_DGRAM, 0) >= 0);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string attempt = argc > 1 ? argv[1] : "";
    const std::string argument = argc > 2 ? argv[2] : "";
    if (attempt == "read")
        tryToRead(argument.c_str());
    else if (attempt == "write")
        tryToWrite(argument);
    else if (attempt == "connect")
        tryToConnect(std::atoi(argument.c_str()));
    else if (attempt == "call")
        tryCall(argument);
    else if (attempt == "socket")
        trySocket(argument);
    else if (attempt == "fork")
        forkUpTo(std::atoi(argument.c_str()));
    else if (attempt == "memory")
        askForMemory(std::strtoul(argument.c_str(), nullptr, 10));
    else if (attempt == "memory-in-many")
        askForMemoryInMany(std::strtoul(argument.c_str(), nullptr, 10));
    else if (attempt == "large-file")
        writeLargeFile(argument, 8);
    else if (attempt == "spin")
        for (volatile unsigned i = 0;;)
            i = i + 1;
    else if (attempt == "user")
        std::printf("uid %u gid %u\n", getuid(), getgid());
    else if (attempt == "environment")
        for (char** each = environ; *each; ++each)
            std::printf("%s\n", *each);
    else
        return 2;
    return 0;
}
