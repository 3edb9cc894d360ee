// Grades submissions that attack (grader/tests/hostile/), and an honest one after each, which must
// get full marks and the same result document as ever. One after the other it makes the
// scoreboard; with --crowd all at once, eight at a time, in random order.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <iostream>
#include <mutex>
#include <random>
#include <thread>

#include "Error.h"
#include "HostileCase.h"

namespace {

using namespace hostile;

constexpr int kAtOnce = 8;
constexpr std::size_t kHonestEvery = 8;  // of a crowd

struct Options {
    std::string only;
    bool crowd = false, update = false;
    unsigned order = std::random_device()();
};

const fs::path kHome = lab::root() / "grader/tests/hostile";

/// What stands in the scoreboard: all but the times, which differ from run to run.
std::string rowOf(const Case& attack, const Outcome& outcome) {
    return fmt::format("| {} | {} | {} | {} | {:g} of {:g} |", attack.name, attack.about,
                       fmt::join(attack.verdicts, ", "), outcome.verdict, outcome.points,
                       attack.mostPoints);
}

class Trial {
public:
    explicit Trial(const Options& options)
        : options_(options), cases_(readCases(kHome, options.only)) {
        for (const Case& attack : cases_)
            if (!usual_.contains(attack.assignment))
                usual_[attack.assignment] = checkedHonest(attack.assignment).document;
    }

    void oneByOne() {
        std::string board;
        for (const Case& attack : cases_) {
            const Outcome outcome = tryCase(attack, world_);
            tell(attack, outcome);
            board += fmt::format("{} {:.0f} s |\n", rowOf(attack, outcome), outcome.seconds);
            checkedHonest(attack.assignment);
        }
        if (options_.update)
            writeBoard(board);
    }

    void crowd() {
        std::cout << "order: " << options_.order << "\n";
        std::shuffle(cases_.begin(), cases_.end(), std::mt19937(options_.order));
        std::atomic<std::size_t> next = 0;
        std::vector<std::thread> workers;
        for (int i = 0; i < kAtOnce; ++i)
            workers.emplace_back([&] {
                for (std::size_t k = next++; k < cases_.size(); k = next++) {
                    tell(cases_[k], tryCase(cases_[k], world_));
                    if (k % kHonestEvery == 0)
                        checkedHonest(cases_[k].assignment);
                }
            });
        for (std::thread& each : workers)
            each.join();
    }

    int failures() const { return failures_; }
    std::size_t count() const { return cases_.size(); }

private:
    Outcome checkedHonest(const std::string& assignment) {
        Outcome outcome = tryHonest(assignment, world_);
        if (usual_.contains(assignment) && outcome.document != usual_.at(assignment))
            outcome.faults.push_back("the honest submission's result is another than before");
        const std::scoped_lock lock(mutex_);
        for (const std::string& each : outcome.faults) {
            ++failures_;
            std::cout << "✗ honest " << assignment << ": " << each << "\n";
        }
        return outcome;
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

    void writeBoard(const std::string& rows) const {
        grader::writeFile(
            kHome / "README.md",
            fmt::format(
                "# Hostile submissions: the scoreboard\n\nWritten by `grading_hostile "
                "--update`, which grades every case and an honest submission after each. "
                "What a case is made of, and how to add one: "
                "[SECURITY.md](../../SECURITY.md).\n\n{} cases.\n\n| case | what is tried "
                "| verdict wanted | verdict | points | time |\n|---|---|---|---|---|---|\n{}",
                cases_.size(), rows));
    }

    const Options& options_;
    World world_;
    std::vector<Case> cases_;
    std::map<std::string, Json> usual_;
    std::mutex mutex_;
    int failures_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Grades submissions that attack, and an honest one after each.");
    app.add_option("--only", options.only, "only cases whose name holds this text");
    app.add_flag("--crowd", options.crowd, "eight at a time, in random order");
    app.add_option("--order", options.order, "number of that order");
    app.add_flag("--update", options.update,
                 "write the scoreboard, grader/tests/hostile/README.md");
    CLI11_PARSE(app, argc, argv);
    try {
        Trial trial(options);
        if (options.crowd)
            trial.crowd();
        else
            trial.oneByOne();
        std::cout << trial.count() << " cases, " << trial.failures() << " failures\n";
        return trial.failures() ? 1 : 0;
    } catch (const std::exception& error) {
        std::cerr << "grading_hostile: " << error.what() << "\n";
        return 2;
    }
}
