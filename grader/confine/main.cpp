// confine cpu=S memory=MIB processes=N file=MIB files=N -- COMMAND…
//
// The last step into the sandbox, run as its unprivileged user, inside its namespaces where there
// are any: sets the limits, gives up every way to gain rights, refuses dangerous system calls, and
// becomes the command. What it takes away cannot be had back.

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>

#include "confine/SystemCalls.h"

namespace {

constexpr int kCannotConfine = 126;

void limit(int resource, rlim_t value) {
    const rlimit both{value, value};
    if (setrlimit(static_cast<__rlimit_resource_t>(resource), &both) != 0)
        throw std::runtime_error(std::string("a limit cannot be set: ") + std::strerror(errno));
}

/// "name=42"
std::pair<std::string, rlim_t> parse(const std::string& word) {
    const auto equals = word.find('=');
    rlim_t value = 0;
    const char* end = word.data() + word.size();
    if (equals == std::string::npos ||
        std::from_chars(word.data() + equals + 1, end, value).ptr != end)
        throw std::runtime_error("expected NAME=NUMBER, found \"" + word + "\"");
    return {word.substr(0, equals), value};
}

void apply(const std::map<std::string, rlim_t>& limits) {
    constexpr rlim_t kMib = 1024 * 1024;
    limit(RLIMIT_CPU, limits.at("cpu"));
    limit(RLIMIT_AS, limits.at("memory") * kMib);
    limit(RLIMIT_NPROC, limits.at("processes"));
    limit(RLIMIT_FSIZE, limits.at("file") * kMib);
    limit(RLIMIT_NOFILE, limits.at("files"));
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_MSGQUEUE, 0);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        throw std::runtime_error("new privileges cannot be given up");
    confine::refuseDangerousCalls();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::map<std::string, rlim_t> limits;
        int at = 1;
        for (; at < argc && std::strcmp(argv[at], "--") != 0; ++at)
            limits.insert(parse(argv[at]));
        if (at + 1 >= argc)
            throw std::runtime_error("no command after --");
        apply(limits);
        execvp(argv[at + 1], argv + at + 1);
        throw std::runtime_error(std::string("cannot start ") + argv[at + 1] + ": " +
                                 std::strerror(errno));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "confine: %s\n", error.what());
        return kCannotConfine;
    }
}
