#include "watch/GradingProcess.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <sstream>

#include "Error.h"

namespace grader {

namespace {

void send(int channel, const Json& message) {
    const std::string line = message.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    for (std::size_t sent = 0; sent < line.size();) {
        const ssize_t wrote = write(channel, line.data() + sent, line.size() - sent);
        if (wrote < 0 && errno != EINTR)
            _exit(1);  // nobody listens any more
        sent += wrote > 0 ? static_cast<std::size_t>(wrote) : 0;
    }
}

/// What the process of the work does. Whatever it ends by, no destructor of the process that it is
/// a copy of may run.
[[noreturn]] void carryOut(const std::function<void(const GradingProcess::Tell&)>& work,
                           int channel, const fs::path& temporary) {
    // Signals reach it as they reach any program; those for the terminal's group do not.
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    setpgid(0, 0);
    setenv("TMPDIR", temporary.c_str(), 1);
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    dup2(nothing, STDIN_FILENO);
    try {
        work([&](const Json& message) { send(channel, message); });
    } catch (const std::exception& error) {
        send(channel, {{"failure", error.what()}});
    }
    std::cout.flush();
    _exit(0);
}

/// Reads /proc/ID/stat: a name in parentheses, which may hold anything, then state and parent
/// (proc(5)). 0 where there is no such process any more.
pid_t parentOf(const fs::path& process) {
    std::ifstream file(process / "stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    char state = '?';
    pid_t parent = 0;
    fields >> state >> parent;
    return parent;
}

/// The kernel's own lists of children are not in every kernel.
std::set<pid_t> childrenOfThis() {
    std::set<pid_t> children;
    for (const fs::path& each : entriesOf("/proc"))
        if (const pid_t id = std::atoi(each.filename().c_str());
            id > 0 && parentOf(each) == getpid())
            children.insert(id);
    return children;
}

/// Kills a process and all that it started, and waits until they are gone. What loses its parent
/// by that becomes this process's child, so that none gets away.
void killWithChildren(pid_t pid) {
    std::set<pid_t> others = childrenOfThis();
    others.erase(pid);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    const auto killAndWait = [](pid_t each) {
        kill(each, SIGKILL);
        while (waitpid(each, nullptr, 0) < 0 && errno == EINTR) {
        }
    };
    killAndWait(pid);
    for (bool any = true; any;) {
        any = false;
        for (const pid_t each : childrenOfThis())
            if (!others.contains(each)) {
                killAndWait(each);
                any = true;
            }
    }
    prctl(PR_SET_CHILD_SUBREAPER, 0);
}

}  // namespace

GradingProcess::GradingProcess(const std::function<void(const Tell&)>& work) {
    int pipes[2];
    if (pipe2(pipes, O_CLOEXEC) != 0)
        throw Error("no pipe can be opened: {}", std::strerror(errno));
    fcntl(pipes[0], F_SETFL, O_NONBLOCK);
    const pid_t parent = getpid();
    std::cout.flush();  // or both would write it
    pid_ = fork();
    if (pid_ == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent)
            _exit(1);
        close(pipes[0]);
        carryOut(work, pipes[1], work_.path());
    }
    close(pipes[1]);
    channel_ = pipes[0];
    if (pid_ < 0) {
        close(channel_);
        throw Error("no process can be started: {}", std::strerror(errno));
    }
}

GradingProcess::~GradingProcess() {
    if (pid_ > 0)
        killWithChildren(pid_);
    close(channel_);
}

std::vector<Json> GradingProcess::take() {
    char buffer[65536];
    ssize_t got = 0;
    while ((got = read(channel_, buffer, sizeof buffer)) > 0 || (got < 0 && errno == EINTR))
        if (got > 0)
            unread_.append(buffer, static_cast<std::size_t>(got));
    std::vector<Json> messages;
    std::size_t from = 0;
    for (auto to = unread_.find('\n'); to != std::string::npos; to = unread_.find('\n', from)) {
        messages.push_back(Json::parse(unread_.substr(from, to - from)));
        from = to + 1;
    }
    unread_.erase(0, from);
    if (!messages.empty() && messages.back().contains("failure")) {
        failure_ = messages.back().at("failure");
        messages.pop_back();
    }
    if (got == 0)
        end();
    return messages;
}

void GradingProcess::end() {
    if (ended_)
        return;
    ended_ = true;
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    if (WIFSIGNALED(status))
        failure_ = fmt::format("the grading was ended from outside (signal {}: {})",
                               WTERMSIG(status), strsignal(WTERMSIG(status)));
    else if (WEXITSTATUS(status) != 0 && failure_.empty())
        failure_ = fmt::format("the grading ended with exit status {}", WEXITSTATUS(status));
}

}  // namespace grader
