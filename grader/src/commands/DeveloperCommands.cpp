#include "commands/DeveloperCommands.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "Error.h"
#include "Manifest.h"
#include "Toolchain.h"
#include "commands/GradeCommand.h"

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

/// Builds one target; the compiler speaks for itself.
void build(const Toolchain& tools, const std::string& target) {
    if (runHere({"cmake", "--build", tools.build.string(), "--target", target}) != 0)
        throw Error("{} could not be built: mend the first error above, then try again", target);
}

}  // namespace

void addWindowCommand(CLI::App& app) {
    static std::string assignment;
    CLI::App* command = app.add_subcommand("window", "build an assignment's window and open it");
    command->add_option("assignment", assignment, "such as 07-camera")->required();
    command->prefix_command();  // --size, --screenshot and so on are the window's own
    command->callback([command] {
        const Toolchain tools = Toolchain::load();
        loadAssignment(tools.root, assignment);
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
        loadAssignment(tools.root, assignment);
        build(tools, assignment + "_debug");
        const std::string program = (tools.build / "debug" / (assignment + "_debug")).string();
        // A test that does not exist must not open a debugger on nothing.
        if (runHere({"sh", "-c", "\"$0\" --gtest_list_tests --gtest_filter=\"$1\" | grep -q '^  '",
                     program, test}) != 0)
            throw Error("{} has no test \"{}\"; {} --gtest_list_tests lists them", assignment, test,
                        program);
        become({"gdb", "-q", "-ex",
                "echo Set a breakpoint in your function (break Camera::rotateUp), then: run\\n",
                "--args", program, "--gtest_filter=" + test, "--gtest_catch_exceptions=0"});
    });
}

}  // namespace grader
