#include "commands/DeveloperCommands.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "Collect.h"
#include "Error.h"
#include "ExitCode.h"
#include "Files.h"
#include "Manifest.h"
#include "Toolchain.h"
#include "watch/Watched.h"

namespace grader {

namespace {

/// Goes on as another program, which has the terminal and its keys (Ctrl-C in a debugger) to
/// itself.
[[noreturn]] void become(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    for (const std::string& each : command)
        arguments.push_back(const_cast<char*>(each.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    dprintf(2, "cannot start %s: %s\n", arguments[0], std::strerror(errno));
    _exit(kGraderFailed);
}

/// Runs a command on this terminal. Returns its exit code.
int runHere(const std::vector<std::string>& command) {
    const pid_t pid = fork();
    if (pid == 0)
        become(command);
    if (pid < 0)
        throw Error("{} cannot be started: {}", command.front(), std::strerror(errno));
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : kGraderFailed;
}

/// Builds one target, as long as nobody else builds (scripts/build.sh has the same lock); the
/// compiler speaks for itself.
void build(const Toolchain& tools, const std::string& target) {
    const FileLock lock(tools.build / "lock", FileLock::Wait::yes);
    if (runHere({"cmake", "--build", tools.build.string(), "--target", target}) != 0)
        throw Error("{} could not be built: mend the first error above, then try again", target);
}

Submission homeOf(const Toolchain& tools) {
    return {tools.root / "assignments", true};
}

/// An assignment that has all the student's files: without one, CMake knows no window of it.
Manifest loadWhole(const Toolchain& tools, const std::string& id) {
    const Manifest manifest = loadAssignment(tools.root, id);
    for (const std::string& name : manifest.submit)
        if (typeOf(manifest.folder / name) == fs::file_type::not_found)
            throw Error("{}", missingStarter(id, name));
    for (const auto& [name, from] : manifest.inherits)
        if (!homeOf(tools).placeOf(manifest, name))
            throw Error("{}", missingStarter(from, name));
    return manifest;
}

/// Where a debugger may stop to see what a test calls: "rotation.cpp:17", the region of its task.
/// Empty where that is gone, or in a shader.
std::string breakpointFor(const Toolchain& tools, const Manifest& manifest,
                          const std::string& test) {
    const std::string suite = test.substr(0, test.find('.'));
    for (const Task& task : manifest.tasks) {
        if (task.suite() != suite)
            continue;
        const fs::path place = placeOfRegion(homeOf(tools), manifest, task.id);
        const std::string name = place.filename().string(), file = name.substr(0, name.rfind(':'));
        if (file.ends_with(".cpp") || isHeader(file))
            return name;
    }
    return "";
}

}  // namespace

void addWindowCommand(CLI::App& app) {
    static std::string assignment;
    CLI::App* command = app.add_subcommand("window", "build an assignment's window and open it");
    command->add_option("assignment", assignment, "such as 07-camera")->required();
    command->prefix_command();  // --size, --screenshot and so on are the window's own
    command->callback([command] {
        const Toolchain tools = Toolchain::load();
        loadWhole(tools, assignment);
        build(tools, assignment);
        std::vector<std::string> window = {(tools.build / "windows" / assignment).string()};
        const auto rest = command->remaining();
        window.insert(window.end(), rest.begin(), rest.end());
        become(window);
    });
}

void addDebugCommand(CLI::App& app) {
    static std::string assignment, test;
    CLI::App* command =
        app.add_subcommand("debug", "run one test in one process under gdb, with your own files");
    command->add_option("assignment", assignment, "such as 07-camera")->required();
    command->add_option("test", test, "SUITE.TEST, as ./grade --json names it")->required();
    command->callback([] {
        const Toolchain tools = Toolchain::load();
        const Manifest manifest = loadWhole(tools, assignment);
        build(tools, assignment + "_debug");
        const std::string program = (tools.build / "debug" / (assignment + "_debug")).string();
        // A test that does not exist must not open a debugger on nothing.
        if (runHere({"sh", "-c", "\"$0\" --gtest_list_tests --gtest_filter=\"$1\" | grep -q '^  '",
                     program, test}) != 0)
            throw Error("{} has no test \"{}\"; {} --gtest_list_tests lists them", assignment, test,
                        program);
        const std::string place = breakpointFor(tools, manifest, test);
        become({"gdb", "-q", "-ex",
                fmt::format("echo Set a breakpoint{}, then: run\\n",
                            place.empty() ? "" : " (break " + place + ")"),
                "--args", program, "--gtest_filter=" + test, "--gtest_catch_exceptions=0"});
    });
}

}  // namespace grader
