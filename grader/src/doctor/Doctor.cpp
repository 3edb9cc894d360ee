#include "doctor/Doctor.h"

#include <fmt/format.h>
#include <sys/timex.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <thread>

#include "Fields.h"
#include "Observe.h"
#include "Process.h"

namespace grader {

namespace {

/// Each line is "Name: value"; all of it can be had from a sandbox's own /usr and /proc. $1 is the
/// kit, which may lie in somebody's /home: the folders that lead to it are there, and nothing else.
constexpr const char* kLookAround = R"sh(
grep -E '^(CapEff|NoNewPrivs|Seccomp):' /proc/self/status
echo "Processes: $(ls /proc | grep -c '^[0-9]')"
echo "Self: $$"
echo "Interfaces:$(tail -n +3 /proc/net/dev | cut -d: -f1 | tr -d '\n')"
look() {
    case "$1" in "$kit") return ;; esac
    case "$kit" in
        "$1"/*) for each in "$1"/* "$1"/.[!.]*; do look "$each"; done ;;
        *) head -c 1 "$1" > /dev/null 2>&1 || ls "$1"/ > /dev/null 2>&1 && seen="$seen $1" ;;
    esac
}
kit=$1
for name in /etc/passwd /root /home /var /run; do look $name; done
echo "Visible:$seen"
echo "Writable:$(for name in / /usr /tmp; do
    { : > $name/.written; } 2> /dev/null && rm $name/.written && printf ' %s' $name
done)"
echo "Cores: $(ulimit -c)"
echo "Memory: $(ulimit -v)"
echo "Threads: $(bash -c 'ulimit -u')"
)sh";

std::string valueOf(const Confession& said, const std::string& name) {
    const auto at = said.find(name);
    return at == said.end() ? "" : at->second;
}

std::string firstLineOf(const char* path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

/// Why bubblewrap does not run here, as far as the system tells.
std::string whyNoNamespaces() {
    if (!run({"bwrap", "--version"}, 10).succeeded())
        return "apt-get install bubblewrap";
    if (firstLineOf("/proc/sys/kernel/apparmor_restrict_unprivileged_userns") == "1")
        return "AppArmor refuses user namespaces: start the grader as root, or sysctl -w "
               "kernel.apparmor_restrict_unprivileged_userns=0";
    if (firstLineOf("/proc/sys/kernel/unprivileged_userns_clone") == "0")
        return "sysctl -w kernel.unprivileged_userns_clone=1";
    if (firstLineOf("/proc/sys/user/max_user_namespaces") == "0")
        return "sysctl -w user.max_user_namespaces=10000";
    return "in a container, allow user namespaces: docker run --security-opt seccomp=unconfined "
           "--security-opt systempaths=unconfined --security-opt apparmor=unconfined";
}

Confession confess(const Toolchain& tools, const Sandbox& sandbox) {
    const JobUser user;
    Confinement confinement;
    confinement.workingFolder = "/";
    confinement.user = user.id();
    confinement.readable = {tools.kit};
    const ProcessResult ran =
        run(sandbox.confine(confinement, {"sh", "-c", kLookAround, "sh", tools.kit.string()}),
            kSandboxPatience);
    Confession said;
    std::istringstream lines(ran.output);
    for (std::string line; std::getline(lines, line);)
        if (const auto colon = line.find(':'); colon != std::string::npos) {
            const auto start = line.find_first_not_of(" \t", colon + 1);
            said[line.substr(0, colon)] = start == std::string::npos ? "" : line.substr(start);
        }
    return said;
}

std::string cpuFlags() {
    std::ifstream file("/proc/cpuinfo");
    std::string found;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("flags"))
            continue;
        line += ' ';
        for (const char* flag : {"sse4_2", "avx", "avx2", "fma", "f16c", "avx512f"})
            if (line.find(std::string(" ") + flag + " ") != std::string::npos)
                found += (found.empty() ? "" : " ") + std::string(flag);
        break;
    }
    return found.empty() ? "unknown" : found;
}

std::string clockState() {
    timex state{};
    const int answer = adjtimex(&state);
    if (answer < 0)
        return "unknown: the system refuses to tell";
    return answer == TIME_ERROR || (state.status & STA_UNSYNC) != 0
               ? "not synchronised: deadlines that are compared with it may be off"
               : "synchronised";
}

std::string kernel() {
    utsname name{};
    uname(&name);
    return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

std::vector<Fact> factsOf(const Toolchain& tools, const Sandbox& sandbox) {
    std::vector<Fact> facts;
    const auto add = [&](const char* id, const char* title, const std::string& value) {
        facts.push_back({id, title, value});
    };
    try {
        const Job job;
        const auto graphics = Observer(tools, sandbox, {}).describeGraphics(job);
        add("renderer", "renderer", graphics.renderer);
        add("gl_version", "OpenGL, Mesa", graphics.version);
        add("context", "context", graphics.provider);
    } catch (const Error& error) {
        add("renderer", "renderer", fmt::format("none: {}", error.what()));
    }
    add("cpu", "processor", cpuModel());
    add("cpu_features", "of its features", cpuFlags());
    add("cores", "cores", std::to_string(std::thread::hardware_concurrency()));
    add("kernel", "kernel", kernel());
    add("compiler", "compiler", tools.compilerVersion);
    add("glm", "GLM", tools.glmVersion);
    add("grader", "grader", tools.version);
    add("kit", "kit", tools.kitFingerprint.substr(0, 16));
    add("clock", "clock", clockState());
    return facts;
}

}  // namespace

std::vector<Defence> defencesFrom(const Confession& said, const std::string& sandbox, bool root) {
    std::vector<Defence> all;
    const auto add = [&](const char* id, const char* title, bool active, std::string found,
                         const std::string& remedy) {
        if (found.empty())
            found = "nothing was said about it";
        all.push_back({id, title, active, std::move(found), active ? "" : remedy});
    };
    const auto is = [&](const char* name, const char* value) {
        return valueOf(said, name) == value;
    };
    const bool namespaces = sandbox == "bubblewrap";
    const std::string how =
        namespaces ? "look at how the grader starts bubblewrap (grader/src/Sandbox.cpp)"
                   : whyNoNamespaces();
    const std::string visible = valueOf(said, "Visible"), writable = valueOf(said, "Writable"),
                      interfaces = valueOf(said, "Interfaces");
    const bool spoke = said.contains("Processes");
    add("namespaces", "namespaces of its own", namespaces,
        namespaces ? "bubblewrap runs" : "bubblewrap does not run", how);
    add("user", "a user of its own for each job", root,
        root ? "started by root"
             : "runs as your own user: the limit of processes counts yours, too",
        "start the grader as root");
    add("files", "sees no file but the system's and its own", spoke && visible.empty(),
        !spoke            ? ""
        : visible.empty() ? "nothing of /etc/passwd, /root, /home, /var, /run"
                          : "it sees " + visible,
        how);
    // In a namespace /tmp is its own, else everybody's.
    add("read_only", "writes nowhere but in its own folders",
        spoke && writable == (namespaces ? "/tmp" : ""),
        "it can write to " + (writable.empty() ? "nothing" : writable), how);
    const std::string processes = valueOf(said, "Processes");
    add("processes", "sees no other process", processes.size() == 1 && is("Self", "1"),
        processes + " to be seen", how);
    add("network", "no network", spoke && (interfaces.empty() || interfaces == "lo"),
        !spoke ? "" : "interfaces: " + (interfaces.empty() ? "none" : interfaces), how);
    add("system_calls", "a filter of system calls", is("Seccomp", "2"),
        "seccomp mode " + valueOf(said, "Seccomp"), "a kernel with CONFIG_SECCOMP_FILTER");
    add("capabilities", "no capabilities, no new ones",
        is("CapEff", "0000000000000000") && is("NoNewPrivs", "1"),
        "CapEff " + valueOf(said, "CapEff"), how);
    add("memory", "limits on memory and threads",
        !valueOf(said, "Memory").empty() && !is("Memory", "unlimited") &&
            !is("Threads", "unlimited"),
        fmt::format("{} KiB each, {} threads", valueOf(said, "Memory"), valueOf(said, "Threads")),
        "do not start the grader where limits cannot be lowered");
    add("core_dumps", "no core dumps", is("Cores", "0"), "limit " + valueOf(said, "Cores"),
        "do not start the grader where limits cannot be lowered");
    return all;
}

Defence defenceInSum(const CgroupHome& home) {
    const bool active = !home.folder().empty();
    return {"cgroup", "limits on memory and threads in sum", active,
            active ? "cgroups in " + home.folder().parent_path().string()
                   : "looked at every 20 ms, not held by the kernel: " + home.found(),
            home.remedy()};
}

bool Diagnosis::allActive() const {
    return std::all_of(defences.begin(), defences.end(),
                       [](const Defence& each) { return each.active; });
}

std::string Diagnosis::text() const {
    std::string text = fmt::format("Sandbox: {}\n\n", sandbox);
    for (const Defence& each : defences) {
        text += fmt::format("{} {:<42} {}\n", each.active ? "✓" : "✗", each.title, each.found);
        if (!each.active)
            text += fmt::format("  → {}\n", each.remedy);
    }
    text += "\nWhat else may make results differ between machines:\n\n";
    for (const Fact& each : facts)
        text += fmt::format("  {:<16} {}\n", each.title, each.value);
    return text + (allActive() ? "\nAll defences are active.\n"
                               : "\nSome defences are not active: grade only code that you trust, "
                                 "as far as they go (grader/SECURITY.md).\n");
}

std::string Diagnosis::json() const {
    Json document = {{"format", 1}, {"sandbox", sandbox}, {"all_active", allActive()}};
    document["defences"] = Json::array();
    for (const Defence& each : defences)
        document["defences"].push_back({{"id", each.id},
                                        {"title", each.title},
                                        {"active", each.active},
                                        {"found", each.found},
                                        {"remedy", each.remedy}});
    document["facts"] = Json::object();
    for (const Fact& each : facts)
        document["facts"][each.id] = each.value;
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Diagnosis diagnose(const Toolchain& tools, const Sandbox& sandbox) {
    Diagnosis diagnosis{sandbox.name(),
                        defencesFrom(confess(tools, sandbox), sandbox.name(), geteuid() == 0),
                        factsOf(tools, sandbox)};
    diagnosis.defences.push_back(defenceInSum(CgroupHome::ours()));
    return diagnosis;
}

}  // namespace grader
