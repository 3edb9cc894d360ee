// What the sandbox costs: a submission with one edited file is graded in bubblewrap and without any
// confinement, in turns. CPU time counts every child. Prints a row per assignment; the difference
// is the median over the rounds' pairs.

#include <cstdlib>
#include <iostream>

#include "Error.h"
#include "Grade.h"
#include "Process.h"
#include "bench/Edit.h"
#include "bench/Median.h"

namespace {

using namespace grader;

/// The command as it is. Only for solutions of our own.
class Unconfined : public Sandbox {
public:
    bool hidesFiles() const override { return true; }  // of itself only
    std::string name() const override { return "none"; }
    std::string weakness() const override { return "nothing is confined"; }
    std::vector<std::string> confine(Confinement confinement,
                                     const std::vector<std::string>& command) const override {
        std::vector<std::string> all = {"env", "-C", confinement.workingFolder.string()};
        all.insert(all.end(), confinement.environment.begin(), confinement.environment.end());
        all.insert(all.end(), command.begin(), command.end());
        return all;
    }
};

class Bench {
public:
    explicit Bench(const Toolchain& tools)
        : bubblewrap_(makeBubblewrap(tools.confine())),
          confined_(tools, *bubblewrap_),
          free_(tools, unconfined_) {}

    void row(const Manifest& manifest, int rounds) {
        std::vector<double> with, without, difference;
        cpuOf(confined_, manifest);  // fills the caches
        for (int round = 0; round < rounds; ++round) {
            with.push_back(cpuOf(confined_, manifest));
            without.push_back(cpuOf(free_, manifest));
            difference.push_back(with.back() - without.back());
            std::cerr << "." << std::flush;
        }
        fmt::print("| {} | {:.0f} | {:.0f} | {:+.0f} | {:.2f} |\n", manifest.id,
                   1000 * median(with), 1000 * median(without), 1000 * median(difference),
                   median(with) / median(without));
        std::fflush(stdout);
    }

private:
    double cpuOf(const Grader& grader, const Manifest& manifest) {
        Stage stage = grader.stageOf(manifest, "solutions");
        for (StagedFile& file : stage.files)
            if (file.role == Role::own && file.name.ends_with(".cpp")) {
                file.content += editOf(file.name, ++edits_);
                break;
            }
        const double before = cpuSeconds();
        const auto result = grader.gradeStaged(manifest, stage, kPublishedSeed);
        const double spent = cpuSeconds() - before;
        if (!result.full())
            throw Error("the solution of {} is not full: {:g} points, {}", manifest.id,
                        result.points(), result.tasks.front().checks.front().message);
        return spent;
    }

    std::unique_ptr<Sandbox> bubblewrap_;
    Unconfined unconfined_;
    Grader confined_, free_;
    int edits_ = 0;
};

}  // namespace

int main(int argc, char** argv) try {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
    if (rounds < 1) {
        std::cerr << "usage: sandbox_benchmark [ROUNDS]\n";
        return 2;
    }
    const Toolchain tools = Toolchain::load();
    fmt::print(
        "Medians of {} rounds, ms of CPU.\n\n"
        "| assignment | in the sandbox | without | difference | ratio |\n|---|---|---|---|---|\n",
        rounds);
    Bench bench(tools);
    for (const std::string& id : knownAssignments(tools.root))
        bench.row(loadAssignment(tools.root, id), rounds);
    return 0;
} catch (const std::exception& error) {
    std::cerr << "benchmark: " << error.what() << "\n";
    return 2;
}
