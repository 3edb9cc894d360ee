#include "commands/BatchCommand.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <optional>
#include <random>
#include <thread>

#include "Error.h"
#include "batch/Batch.h"
#include "batch/Overview.h"
#include "batch/Progress.h"
#include "commands/GradeCommand.h"

namespace grader {

namespace {

struct Options {
    std::string submissions, assignment, out;
    int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::optional<std::uint64_t> seed;
    bool fresh = false, quiet = false, noSandbox = false;
};

std::atomic<bool> stop = false;

void onInterrupt(int) {
    stop = true;
    std::signal(SIGINT, SIG_DFL);  // the second time at once
}

/// Other people's code is not run where nothing holds it, unless somebody insists.
std::unique_ptr<Sandbox> sandboxFor(const Toolchain& tools, bool noSandbox) {
    if (noSandbox)
        return makePlainProcess(tools.confine());
    auto sandbox = chooseSandbox(tools.confine());
    if (sandbox->name() == "plain" && geteuid() != 0)
        throw Error(
            "there is no sandbox on this machine, and a batch runs other people's code: ./grade "
            "doctor says how to get one; start the grader as root; or insist with --no-sandbox");
    return sandbox;
}

/// The batch's own seed: chosen once, kept beside the results, nobody's to know before.
std::uint64_t seedFor(const Options& options, const Toolchain& tools, const fs::path& file) {
    std::optional<std::uint64_t> kept;
    if (fs::exists(file)) {
        const Json json = parseJsonFile(file.string());
        if (json.at("assignment") != options.assignment)
            throw Error("{} holds results of {}, not of {}: choose another --out", options.out,
                        json.at("assignment").get<std::string>(), options.assignment);
        kept = json.at("seed").get<std::uint64_t>();
    }
    std::uint64_t seed = kPublishedSeed;
    if (options.seed || kept)
        seed = options.seed.value_or(*kept);
    else if (fs::is_directory(tools.root / "solutions" / options.assignment))
        seed = std::random_device()();
    writeFile(
        file,
        Json{{"format", 1}, {"assignment", options.assignment}, {"seed", seed}}.dump(2) + "\n");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    return seed;
}

std::string lineOf(const Standing& standing) {
    if (!standing.sentence.empty())
        return fmt::format("{}: {}: {}", standing.student, standing.status, standing.sentence);
    return fmt::format("{} {:g} of {:g}{}", standing.student, standing.points, standing.maxPoints,
                       standing.fromBefore ? " (as before)" : "");
}

int runBatch(const Options& options) {
    const Toolchain tools = Toolchain::load();
    const Manifest manifest = loadAssignment(tools.root, options.assignment);
    const Intake intake = takeIn(options.submissions, manifest, knownAssignments(tools.root));
    const auto sandbox = sandboxFor(tools, options.noSandbox);
    const fs::path out = options.out;
    fs::create_directories(out);
    const std::uint64_t seed = seedFor(options, tools, out / "batch.json");
    const Ledger ledger(out);
    const Grader grader(tools, *sandbox);
    const Batch batch(grader, *sandbox, manifest, ledger, seed,
                      keyOfRules(tools, *sandbox, manifest, seed));

    std::signal(SIGINT, onInterrupt);
    Progress progress(intake.entrants.size(), options.quiet);
    const auto standings =
        batch.run(intake.entrants, options.jobs, options.fresh, stop, [&](const Standing& each) {
            progress.count(lineOf(each), each.graderFailed(), each.fromBefore);
        });
    progress.end();
    const Overview overview{manifest, standings, intake.ignored, seed, sandbox->name()};
    writeFile(out / "results.json", overview.json());
    writeFile(out / "results.csv", overview.csv());
    writeFile(out / "index.html", overview.html());

    const auto faults = std::count_if(standings.begin(), standings.end(),
                                      [](const Standing& each) { return each.graderFailed(); });
    const std::size_t left = intake.entrants.size() - standings.size();
    std::cout << fmt::format("{} of {} submissions have a result{}{}\n",
                             standings.size() - static_cast<std::size_t>(faults),
                             intake.entrants.size(),
                             faults ? fmt::format(", {} met a fault of the grader", faults) : "",
                             left ? ", stopped: the same command goes on" : "")
              << "Overview: " << fs::absolute(out / "index.html").string() << "\n";
    return faults || left ? kGraderFailed : kFullMarks;
}

}  // namespace

void addBatchCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command =
        app.add_subcommand("batch", "grade a folder of submissions of one assignment");
    command
        ->add_option("submissions", options.submissions,
                     "folder with a folder or an archive for each student")
        ->required();
    command->add_option("--assignment", options.assignment, "the assignment, such as 06-rotation")
        ->required();
    command->add_option("--out", options.out, "folder for results; what it holds is gone on from")
        ->required();
    command->add_option("--jobs", options.jobs, "submissions at a time")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--seed", options.seed,
                        "seed of random inputs; default a secret one, the same for all");
    command->add_flag("--fresh", options.fresh, "grade again what is known already");
    command->add_flag("--quiet", options.quiet, "show no progress");
    command->add_flag("--no-sandbox", options.noSandbox,
                      "run the code as plain processes with limits");
    command->callback([&exitCode] { exitCode = runBatch(options); });
}

}  // namespace grader
