// The two steps of ours into a sandbox. Both become the command that follows.
//
//   confine enter USER FOLDER CGROUP NAME=VALUE… -- COMMAND…
//       the first: moves into CGROUP (-: stays where it is), works in FOLDER with these variables
//       and no others; root becomes USER, without groups. (USER 0: stays who it is, unless it is
//       root.)
//   confine limit cpu=S memory=MIB processes=N file=MIB files=N [read=PATH… write=PATH…] --
//   COMMAND…
//       the last, inside the namespaces where there are any: sets the limits, gives up every way to
//       gain rights, refuses dangerous system calls and, where paths are named, other files. What
//       it takes away cannot be had back.
//
// Linked statically: started several times for each submission, it must cost next to nothing.

#include <fcntl.h>
#include <grp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "confine/FileRules.h"
#include "confine/SystemCalls.h"

namespace {

constexpr int kCannotConfine = 126;

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what + ": " + std::strerror(errno));
}

rlim_t numberIn(std::string_view text) {
    rlim_t value = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (text.empty() || read.ptr != end || read.ec != std::errc())
        throw std::runtime_error("expected a number, found \"" + std::string(text) + "\"");
    return value;
}

/// argv from `at` to "--"; leaves `at` behind it.
template <class Take>
void takeUntilDashes(char** argv, int argc, int& at, Take&& take) {
    for (; at < argc && std::strcmp(argv[at], "--") != 0; ++at)
        take(argv[at]);
    if (++at >= argc)
        throw std::runtime_error("no command after --");
}

void moveInto(const std::string& cgroup) {
    if (cgroup == "-")
        return;
    const int file = open((cgroup + "/cgroup.procs").c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0 || write(file, "0", 1) != 1)
        fail("cannot enter the cgroup " + cgroup);
    close(file);
}

void becomeUser(gid_t user) {
    if (geteuid() != 0)
        return;
    if (user == 0)
        throw std::runtime_error("root must become somebody else");
    if (setgroups(0, nullptr) != 0 || setresgid(user, user, user) != 0 ||
        setresuid(user, user, user) != 0)
        fail("cannot become user " + std::to_string(user));
}

void enter(char** argv, int argc, int& at) {
    if (argc < at + 3)
        throw std::runtime_error("expected a user, a folder and a cgroup");
    const auto user = static_cast<gid_t>(numberIn(argv[at++]));
    const char* folder = argv[at++];
    const char* cgroup = argv[at++];
    clearenv();
    takeUntilDashes(argv, argc, at, [](char* variable) {
        if (!std::strchr(variable, '=') || putenv(variable) != 0)
            throw std::runtime_error("expected NAME=VALUE, found \"" + std::string(variable) +
                                     "\"");
    });
    if (chdir(folder) != 0)
        fail(std::string("cannot work in ") + folder);
    moveInto(cgroup);
    becomeUser(user);
}

void setLimit(std::string_view word) {
    constexpr rlim_t kMib = 1024 * 1024;
    struct Kind {
        std::string_view name;
        __rlimit_resource resource;
        rlim_t unit;
    };
    static constexpr Kind kKinds[] = {{"cpu", RLIMIT_CPU, 1},
                                      {"memory", RLIMIT_AS, kMib},
                                      {"processes", RLIMIT_NPROC, 1},
                                      {"file", RLIMIT_FSIZE, kMib},
                                      {"files", RLIMIT_NOFILE, 1}};
    const auto equals = word.find('=');
    for (const Kind& kind : kKinds) {
        if (equals == word.npos || kind.name != word.substr(0, equals))
            continue;
        const rlim_t number = numberIn(word.substr(equals + 1));
        if (number > RLIM_INFINITY / kind.unit)
            throw std::runtime_error("the limit " + std::string(word) + " is too large");
        const rlim_t value = number * kind.unit;
        const rlimit both{value, value};
        if (setrlimit(kind.resource, &both) != 0)
            fail("the limit " + std::string(word) + " cannot be set");
        return;
    }
    throw std::runtime_error("no limit is called \"" + std::string(word) + "\"");
}

void limit(char** argv, int argc, int& at) {
    constexpr std::string_view kRead = "read=", kWrite = "write=";
    std::vector<std::string> readable, writable;
    takeUntilDashes(argv, argc, at, [&](std::string_view word) {
        if (word.substr(0, kRead.size()) == kRead)
            readable.emplace_back(word.substr(kRead.size()));
        else if (word.substr(0, kWrite.size()) == kWrite)
            writable.emplace_back(word.substr(kWrite.size()));
        else
            setLimit(word);
    });
    const rlimit nothing{0, 0};
    if (setrlimit(RLIMIT_CORE, &nothing) != 0 || setrlimit(RLIMIT_MSGQUEUE, &nothing) != 0)
        fail("core dumps cannot be given up");
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        fail("new privileges cannot be given up");
    if (!readable.empty() || !writable.empty())
        confine::holdToFiles(readable, writable);
    confine::refuseDangerousCalls();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::string_view step = argc > 1 ? argv[1] : "";
        int at = 2;
        if (step == "enter")
            enter(argv, argc, at);
        else if (step == "limit")
            limit(argv, argc, at);
        else
            throw std::runtime_error("expected enter or limit: started by the grader, not by hand");
        execvp(argv[at], argv + at);
        fail(std::string("cannot start ") + argv[at]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "confine: %s\n", error.what());
        return kCannotConfine;
    }
}
