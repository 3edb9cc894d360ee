#include "commands/BatchCommand.h"

#include <malloc.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <thread>

#include "Error.h"
#include "ExitCode.h"
#include "batch/Batch.h"
#include "batch/Earlier.h"
#include "batch/Marks.h"
#include "batch/Overview.h"
#include "batch/Progress.h"
#include "batch/Written.h"
#include "report/PlainText.h"

namespace grader {

namespace {

/// The part of the class that this machine grades: the index-th of count.
struct Shard {
    std::size_t index = 1, count = 1;

    explicit Shard(const std::string& text = "1/1") {
        std::istringstream in(text);
        char slash = 0;
        const bool signless = text.find_first_not_of("0123456789/") == std::string::npos;
        if (!signless || !(in >> index >> slash >> count) || slash != '/' || !in.eof() ||
            index < 1 || index > count)
            throw Error("--shard {}: expected a part of a whole like 2/8, counted from 1", text);
    }
    bool holds(std::size_t which) const { return which % count == index - 1; }
};

struct Options {
    std::string submissions, assignment, out, roster, policy, times, overrides;
    std::vector<std::string> compareWith;
    AttemptRule attempt = AttemptRule::last;
    int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::optional<std::uint64_t> seed;
    std::optional<double> longest;
    bool fresh = false, stable = false, quiet = false, noSandbox = false;
    Shard shard;
};

std::atomic<bool> stop = false;

void onInterrupt(int signal) {
    stop = true;
    std::signal(signal, SIG_DFL);  // the second time at once
}

/// From now on both ask for an end; what is being graded is graded to the end first.
void stopWhenAsked() {
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
}

/// The batch's own seed: chosen once, kept beside the results, nobody's to know before.
std::uint64_t seedFor(const Options& options, const Toolchain& tools, const fs::path& file) {
    std::optional<std::uint64_t> kept;
    if (fs::exists(file)) {
        const auto [assignment, seed] =
            fromWritten(file, "give the --seed of then and move it away, or choose another --out",
                        [](const Json& json) {
                            return std::pair{json.at("assignment").get<std::string>(),
                                             json.at("seed").get<std::uint64_t>()};
                        });
        if (assignment != options.assignment)
            throw Error("{} holds results of {}, not of {}: choose another --out", options.out,
                        assignment, options.assignment);
        kept = seed;
    }
    std::uint64_t seed = kPublishedSeed;
    if (options.seed || kept)
        seed = options.seed ? *options.seed : *kept;
    else if (canDrawReferences(tools.root, options.assignment))
        seed = std::random_device()();
    writeFile(
        file,
        Json{{"format", 1}, {"assignment", options.assignment}, {"seed", seed}}.dump(2) + "\n");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    return seed;
}

std::string lineOf(const Standing& standing) {
    const char* before = standing.fromBefore ? " (as before)" : "";
    if (!standing.sentence.empty())
        return fmt::format("{}: {}: {}{}", standing.entrant, standing.status, standing.sentence,
                           before);
    return fmt::format("{} {:g} of {:g}{}", standing.entrant, standing.points, standing.maxPoints,
                       before);
}

/// Everything that people say about the class.
struct Rules {
    std::optional<std::vector<Student>> roster;
    Policy policy;
    Overrides overrides;

    Rules(const Options& options, const Manifest& manifest) {
        if (!options.roster.empty())
            roster = readRoster(options.roster);
        if (!options.policy.empty())
            policy = Policy::load(options.policy);
        if (!options.overrides.empty())
            overrides =
                Overrides(options.overrides, fs::path(options.out) / "overrides.json", manifest);
    }
};

/// A folder; or the archive that a learning platform exported, unpacked.
fs::path folderOf(const Toolchain& tools, const Sandbox& sandbox, const Job& job,
                  const fs::path& submissions) {
    if (!fs::is_regular_file(submissions))
        return submissions;
    const Unpacked unpacked =
        unpackArchive(tools, sandbox, job, submissions, knownAssignments(tools.root));
    if (!unpacked.refusal.empty())
        throw Error("{} is refused: {}; unpack it yourself, and give the folder",
                    submissions.string(), unpacked.refusal);
    return unpacked.folder;
}

std::vector<std::string> namesOf(const ClassList& list) {
    std::vector<std::string> names;
    for (const Participant& each : list.participants)
        names.push_back(each.student.id);
    return names;
}

/// What an instructor must hear of beside the marks.
std::vector<std::string> notTaken(const Intake& intake, const ClassList& list, const Rules& rules) {
    std::vector<std::string> all = intake.ignored;
    all.insert(all.end(), list.unclear.begin(), list.unclear.end());
    for (const Participant& each : list.participants)
        if (rules.roster && !each.inRoster)
            all.push_back(each.student.id + " is not in the roster");
    for (const std::string& each : rules.overrides.strangers(namesOf(list)))
        all.push_back("a decision is about " + each + ", who is not there");
    return all;
}

/// Of the class those that hand in what this shard grades; who handed in nothing is in all of them.
ClassList partOf(ClassList list, const Shard& shard) {
    std::size_t which = 0;
    std::erase_if(list.participants, [&](const Participant& each) {
        return !each.attempts.empty() && !shard.holds(which++);
    });
    return list;
}

/// The submissions that are to be graded, each once.
std::vector<Entrant> chosen(const ClassList& list, const Options& options, const Policy& policy) {
    std::map<std::string, const Entrant*> all;
    for (const Participant& each : list.participants)
        for (const Entrant* entrant : attemptsToGrade(each, options.attempt, policy))
            all[entrant->name] = entrant;
    std::vector<Entrant> entrants;
    for (const auto& [name, entrant] : all)
        entrants.push_back(*entrant);
    return entrants;
}

struct Graded {
    std::map<std::string, Standing> standings;  ///< by the entrant's name
    bool someoneWasLeftBehind = false;          ///< see Crew
};

Graded gradeAll(const Options& options, const Batch& batch, const std::vector<Entrant>& entrants) {
    Progress progress(entrants.size(), options.quiet);
    Crew::Done done =
        batch.run(entrants, options.jobs, options.fresh, stop, [&](const Standing& standing) {
            progress.count(lineOf(standing), standing.graderFailed(), standing.fromBefore);
        });
    progress.end();
    Graded graded;
    graded.someoneWasLeftBehind = done.someoneWasLeftBehind;
    for (auto& each : done.standings)
        if (each)
            graded.standings.emplace(each->entrant, std::move(*each));
    return graded;
}

/// Returns the exit code.
int sayHowItEnded(const Graded& graded, std::size_t entrants) {
    const auto faults = static_cast<std::size_t>(
        std::count_if(graded.standings.begin(), graded.standings.end(),
                      [](const auto& each) { return each.second.graderFailed(); }));
    const std::size_t left = entrants - graded.standings.size();
    std::cout << fmt::format("{} of {} submissions have a result{}{}\n",
                             graded.standings.size() - faults, entrants,
                             faults ? fmt::format(", {} met a fault of the grader", faults) : "",
                             left ? ", stopped: the same command goes on" : "");
    return faults || left ? kGraderFailed : kFullMarks;
}

void sayWhereToLook(const std::vector<std::string>& leftOut, const fs::path& out) {
    for (const std::string& each : leftOut)
        std::cout << "Look at: " << harmless(each) << "\n";
    std::cout << "Overview: " << fs::absolute(out / "index.html").string() << "\n";
}

/// Pictures come and go for thousands of submissions. Each goes back to the system at its end, in
/// place of leaving a hole in the heap of whichever thread had it.
void keepPicturesOffTheHeap() {
    constexpr int kSmallestPicture = 1 << 17;  // bytes
    mallopt(M_MMAP_THRESHOLD, kSmallestPicture);
}

int runBatch(const Options& options) {
    keepPicturesOffTheHeap();
    const Toolchain tools = Toolchain::load();
    const Manifest manifest = loadAssignment(tools.root, options.assignment);
    const auto sandbox =
        chooseSandbox(tools.confine(), {.none = options.noSandbox,
                                        .strangers = true,
                                        .secrets = {tools.root, options.submissions, options.out}});
    const fs::path out = options.out;
    const std::vector<Print> earlier = earlierPrints(options.compareWith, options.assignment);
    removeAbandonedWork();
    stopWhenAsked();
    Rules rules(options, manifest);
    const Job unpacking;
    Intake intake = takeIn(folderOf(tools, *sandbox, unpacking, options.submissions), manifest,
                           knownAssignments(tools.root));
    if (!options.times.empty())
        addTimes(intake, options.times);
    const ClassList everybody = whoIsWho(intake, rules.roster ? &*rules.roster : nullptr);
    const ClassList list = partOf(everybody, options.shard);
    const auto entrants = chosen(list, options, rules.policy);

    fs::create_directories(out);
    const FileLock lock(out / "lock", FileLock::Wait::no);
    if (!lock.held())
        throw Error("another batch is writing to {}: wait for it, or choose another --out",
                    out.string());
    const std::uint64_t seed = seedFor(options, tools, out / "batch.json");
    const Ledger ledger(out);
    const Grader grader(tools, *sandbox);
    const Batch batch(
        grader, *sandbox, manifest, ledger,
        {seed, keyOfRules(grader, *sandbox, manifest, seed),
         options.longest.value_or(longestGrading(manifest) * (options.stable ? 3 : 1)),
         options.stable});
    const Graded graded = gradeAll(options, batch, entrants);

    const auto marks =
        marksOf(manifest, list, graded.standings, options.attempt, rules.policy, rules.overrides);
    rules.overrides.remember();
    const auto likenesses = likenessesAmong(ledger, marks, earlier);
    const auto leftOut = notTaken(intake, everybody, rules);
    const auto classIds = namesOf(everybody);
    writeOverview({manifest, marks, leftOut, likenesses, classIds, seed,
                   Json{{"sandbox", sandbox->name()},
                        {"grader", tools.version},
                        {"compiler", tools.compilerVersion},
                        {"cpu", cpuModel()}}},
                  out);

    const int exitCode = sayHowItEnded(graded, entrants.size());
    sayWhereToLook(leftOut, out);
    if (graded.someoneWasLeftBehind) {
        // A thread that hangs still holds on to all this, so nothing may be taken apart.
        std::cout.flush();
        std::quick_exit(exitCode);
    }
    return exitCode;
}

}  // namespace

void addBatchCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command =
        app.add_subcommand("batch", "grade a folder of submissions of one assignment");
    command
        ->add_option("submissions", options.submissions,
                     "folder with a folder, a git clone or an archive for each student; or the "
                     "export of Canvas, Moodle or Gradescope, unpacked or not")
        ->required();
    command->add_option("--assignment", options.assignment, "the assignment, such as 06-rotation")
        ->required();
    command->add_option("--out", options.out, "folder for results; what it holds is gone on from")
        ->required();
    command->add_option("--roster", options.roster,
                        "table of the class: id, name, email, section, group, due, extension");
    command->add_option("--policy", options.policy,
                        "deadline and what being late costs, a JSON file");
    command->add_option("--times", options.times,
                        "table that says when each was handed in: submission, submitted, student");
    command->add_option("--attempt", options.attempt, "which of several submissions of one counts")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, AttemptRule>{{"last", AttemptRule::last},
                                               {"on-time", AttemptRule::onTime},
                                               {"best", AttemptRule::best}}))
        ->default_str("last");
    command->add_option("--overrides", options.overrides,
                        "table of decisions that take the place of automatic points: student, "
                        "task, points, reason");
    command->add_option(
        "--compare-with", options.compareWith,
        "--out of an earlier batch of the assignment, whose submissions get no mark "
        "but are looked at for likenesses; may be said several times");
    command->add_option("--jobs", options.jobs, "submissions at a time")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command
        ->add_option("--seed", options.seed,
                     "seed of random inputs; default a secret one, the same for all")
        ->envname("COURSE_SEED");
    command
        ->add_option_function<std::string>(
            "--shard", [](const std::string& text) { options.shard = Shard(text); },
            "grade the i-th of n parts of the class, i/n; give all the same --seed, then: merge")
        ->default_str("1/1");
    command
        ->add_option(
            "--longest", options.longest,
            "seconds after which grading one submission is ended, and counts as a fault of "
            "the grader; default what its parts may take at most, according to the "
            "assignment's limits")
        ->check(CLI::Range(0.01, 1e6));
    command->add_flag("--stable", options.stable,
                      "grade each three times, and name those that come out differently");
    command->add_flag("--fresh", options.fresh, "grade again what is known already");
    command->add_flag("--quiet", options.quiet, "show no progress");
    command->add_flag("--no-sandbox", options.noSandbox,
                      "run the code as plain processes with limits");
    command->callback([&exitCode] { exitCode = runBatch(options); });
}

}  // namespace grader
