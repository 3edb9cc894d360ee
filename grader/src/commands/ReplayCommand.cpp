#include <iostream>

#include "Error.h"
#include "ExitCode.h"
#include "Grade.h"
#include "batch/Ledger.h"
#include "batch/Replay.h"
#include "batch/Written.h"
#include "commands/ClassCommands.h"
#include "report/PlainText.h"

namespace grader {

namespace {

/// OUT/students/NAME/result.json, or the folder that it lies in.
int replay(const fs::path& named, bool noSandbox) {
    const fs::path file =
        fs::weakly_canonical(fs::is_directory(named) ? named / "result.json" : named);
    if (!fs::exists(file))
        throw Error("{}: there is no such result; give OUT/students/NAME of a batch",
                    named.string());
    const fs::path home = file.parent_path();
    const std::string entrant = home.filename().string();
    const Ledger ledger(home.parent_path().parent_path());
    const Json record = ledger.record(entrant);
    const Json then = resultIn(file);
    if (!record.contains("assignment"))
        throw Error("{} has no record beside it (instructor/{}/record.json): {}", file.string(),
                    entrant,
                    then.value("status", "") == "refused"
                        ? "its archive was refused, so there is nothing to grade again"
                        : "only what ./grade batch wrote can be replayed");

    const Toolchain tools = Toolchain::load();
    const auto sandbox = chooseSandbox(
        tools.confine(), {.none = noSandbox, .strangers = true, .secrets = {tools.root, home}});
    const Grader grader(tools, *sandbox);
    const AssignmentResult result =
        grader.grade(loadAssignment(tools.root, record.at("assignment")),
                     {ledger.submissionOf(entrant), true}, record.at("seed").get<std::uint64_t>());
    if (result.graderFailed())
        throw Error("the grader itself failed while it graded {} again", entrant);
    const Json now = Json::parse(toJson(result));
    for (const std::string& each : changesOfEnvironment(then, now))
        std::cout << "Changed: " << each << "\n";
    const auto differences = differencesOf(then, now);
    for (const std::string& each : differences)
        std::cout << "Differs: " << each << "\n";
    std::cout << fmt::format("{}: {:g} points then, {:g} now: the mark {}\n", harmless(entrant),
                             then.at("points").get<double>(), now.at("points").get<double>(),
                             differences.empty() ? "agrees" : "does not agree");
    return differences.empty() ? kFullMarks : kSomethingLost;
}

}  // namespace

void addReplayCommand(CLI::App& app, int& exitCode) {
    static std::string result;
    static bool noSandbox = false;
    CLI::App* command = app.add_subcommand(
        "replay", "grade one submission of a batch again, and say whether the mark agrees");
    command->add_option("result", result, "OUT/students/NAME, or the result.json in it")
        ->required();
    command->add_flag("--no-sandbox", noSandbox, "run the code as plain processes with limits");
    command->callback([&exitCode] { exitCode = replay(result, noSandbox); });
}

}  // namespace grader
