// Grades submissions that attack (grader/tests/hostile/), and an honest one after each, which must
// get full marks and the same result document as ever. In their order they make the scoreboard;
// with --crowd they come in random order, eight at a time, and what follows each is one and the
// same half-right submission, which must earn the same parts of its points every time. With --plain
// all are graded without a sandbox, which takes root: a user of its own, limits, the filter and
// Landlock must hold whatever needs no namespace. At the end no process of a submission may be
// left.

#include <sys/utsname.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <mutex>
#include <random>
#include <sstream>
#include <thread>

#include "Error.h"
#include "HostileCase.h"
#include "Sandbox.h"

namespace {

using namespace hostile;

constexpr int kCrowd = 8;     // at a time
constexpr int kSkipped = 77;  // exit code: could not be tried here
const std::string kHalfRightOne = "half-right " + kHalfRight;

struct Options {
    std::string only;
    int jobs = 1;
    std::size_t most = std::size_t(-1);
    bool crowd = false, plain = false, update = false;
    unsigned order = std::random_device()();
};

const fs::path kHome = lab::root() / "grader/tests/hostile";

/// A line of the scoreboard.
std::string rowOf(const Case& attack, const Outcome& outcome) {
    return fmt::format("| {} | {} | {} | {}{} | {:g} (at most {:g}) | {:.0f} s |", attack.name,
                       attack.about, fmt::join(attack.verdicts, ", "),
                       outcome.faults.empty() ? "" : "**wrong:** ", outcome.verdict, outcome.points,
                       attack.mostPoints, outcome.seconds);
}

/// "Debian GNU/Linux 12 (bookworm), Linux 6.1.0".
std::string system() {
    std::string name = "a system without a name";
    std::istringstream lines(grader::readFile("/etc/os-release"));
    const std::string key = "PRETTY_NAME=";
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(key))
            name = line.substr(key.size());
    std::erase(name, '"');
    utsname kernel{};
    uname(&kernel);
    const std::string release = kernel.release;  // what follows the number is the builder's
    return fmt::format("{}, {} {}", name, kernel.sysname,
                       release.substr(0, release.find_first_not_of("0123456789.")));
}

class Trial {
public:
    explicit Trial(const Options& options)
        : options_(options), world_(options.plain), cases_(readCases(kHome, options.only)) {
        if (options.plain)
            leaveOutWhatNeedsASandbox();
        for (const Case& attack : cases_)
            if (!usual_.contains(attack.assignment))
                usual_[attack.assignment] =
                    checked(attack.assignment, tryHonest(attack.assignment, world_));
        usual_[kHalfRightOne] = checked(kHalfRightOne, tryHalfRight(world_));
    }

    void run() {
        if (options_.crowd) {
            std::cout << "order: " << options_.order << "\n";
            std::shuffle(cases_.begin(), cases_.end(), std::mt19937(options_.order));
        }
        cases_.resize(std::min(cases_.size(), options_.most));
        outcomes_.resize(cases_.size());
        std::atomic<std::size_t> next = 0;
        std::vector<std::thread> workers;
        for (int i = 0; i < (options_.crowd ? kCrowd : options_.jobs); ++i)
            workers.emplace_back([&] {
                for (std::size_t k = next++; k < cases_.size(); k = next++) {
                    outcomes_[k] = tryCase(cases_[k], world_);
                    tell(cases_[k], outcomes_[k]);
                    if (options_.crowd)
                        checked(kHalfRightOne, tryHalfRight(world_));
                    else
                        checked(cases_[k].assignment, tryHonest(cases_[k].assignment, world_));
                }
            });
        for (std::thread& each : workers)
            each.join();
        lookForSurvivors();
        if (options_.update)
            writeBoard();
    }

    int failures() const { return failures_; }
    std::size_t count() const { return cases_.size(); }
    int honestResults() const { return honestResults_; }

private:
    void leaveOutWhatNeedsASandbox() {
        const bool closesFiles = grader::makePlainProcess("")->hidesFiles();
        std::erase_if(cases_, [&](const Case& attack) {
            const std::string& why =
                attack.plain.empty() && !closesFiles ? attack.withoutLandlock : attack.plain;
            if (!why.empty())
                std::cout << fmt::format("– {:<32} not tried: {}\n", attack.name, why);
            return !why.empty();
        });
    }

    /// The result of an honest submission, which must be the same as ever.
    Json checked(const std::string& name, Outcome outcome) {
        if (usual_.contains(name) && outcome.document != usual_.at(name))
            outcome.faults.push_back("its result is another than before");
        const std::scoped_lock lock(mutex_);
        ++honestResults_;
        for (const std::string& each : outcome.faults) {
            ++failures_;
            std::cout << "✗ honest " << name << ": " << each << "\n";
        }
        return outcome.document;
    }

    /// What was killed may take a moment to be gone.
    void lookForSurvivors() {
        std::vector<std::string> left = survivors();
        for (int tenths = 0; tenths < 30 && !left.empty(); ++tenths) {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            left = survivors();
        }
        for (const std::string& each : left) {
            ++failures_;
            std::cout << "✗ still there: " << each << "\n";
        }
    }

    void tell(const Case& attack, const Outcome& outcome) {
        const std::scoped_lock lock(mutex_);
        std::cout << fmt::format("{} {:<32} {:<15} {:>5.4g} points {:>5.1f} s\n",
                                 outcome.faults.empty() ? "✓" : "✗", attack.name, outcome.verdict,
                                 outcome.points, outcome.seconds);
        for (const std::string& each : outcome.faults) {
            ++failures_;
            std::cout << "    " << each << "\n";
        }
        std::cout << std::flush;
    }

    /// Who tried the cases, and where.
    std::string circumstances() const {
        const Json& environment = usual_.at(kHalfRightOne).at("environment");
        return fmt::format("Tried by {}, with the sandbox `{}`, on {}.",
                           geteuid() == 0 ? "root" : "an ordinary user",
                           environment.at("sandbox").get<std::string>(), system());
    }

    void writeBoard() const {
        std::string rows;
        for (std::size_t k = 0; k < cases_.size(); ++k)
            rows += rowOf(cases_[k], outcomes_[k]) + "\n";
        const auto green = std::count_if(outcomes_.begin(), outcomes_.end(),
                                         [](const Outcome& each) { return each.faults.empty(); });
        grader::writeFile(
            kHome / "README.md",
            fmt::format("# Hostile submissions: the scoreboard\n\nWritten by `grading_hostile "
                        "--update`, which grades every case and an honest submission after each. "
                        "What a case is made of, and how to add one: "
                        "[SECURITY.md](../../SECURITY.md).\n\n{} {} cases, {} of them green.\n\n| "
                        "case | what is tried | verdict wanted | verdict | points | time "
                        "|\n|---|---|---|---|---|---|\n{}",
                        circumstances(), cases_.size(), green, rows));
    }

    const Options& options_;
    World world_;
    std::vector<Case> cases_;
    std::vector<Outcome> outcomes_;  ///< in the order of the cases
    std::map<std::string, Json> usual_;
    std::mutex mutex_;
    int failures_ = 0, honestResults_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Grades submissions that attack, and an honest one after each.");
    auto* only = app.add_option("--only", options.only, "only cases whose name holds this text");
    app.add_option("--jobs", options.jobs, "how many at a time")->check(CLI::PositiveNumber);
    auto* crowd = app.add_flag("--crowd", options.crowd, "eight at a time, in random order");
    app.add_option("--order", options.order, "number of that order")->needs(crowd);
    app.add_option("--most", options.most, "so many of the crowd")->needs(crowd);
    auto* plain = app.add_flag("--plain", options.plain,
                               "as root: in plain processes (--no-sandbox), but for the cases that "
                               "only a sandbox can hold");
    app.add_flag("--update", options.update, "write the scoreboard, grader/tests/hostile/README.md")
        ->excludes(crowd)
        ->excludes(only)
        ->excludes(plain);
    CLI11_PARSE(app, argc, argv);
    if (options.plain && geteuid() != 0) {
        std::cout << "not tried: without a sandbox only root can start a submission as another "
                     "user\n";
        return kSkipped;
    }
    try {
        Trial trial(options);
        trial.run();
        std::cout << trial.count() << " cases, " << trial.honestResults() << " honest results, "
                  << trial.failures() << " failures\n";
        return trial.failures() ? 1 : 0;
    } catch (const std::exception& error) {
        std::cerr << "grading_hostile: " << error.what() << "\n";
        return 2;
    }
}
