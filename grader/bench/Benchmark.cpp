// What grading costs, measured side by side in one run.
//
//   (a) the bare cost of one submission: plain compiler calls with the grader's flags and
//       precompiled prelude, all files at once, a link, and the runner without sandbox drawing the
//       frames. No check is made.
//   (b) `./grade ASSIGNMENT --submission DIR` after an edit of one file, until it has ended. Once
//       more with an empty object cache, as for a submission that was never seen.
//   (c) the usual way: a CMake configure and build of tests and a renderer (framework and
//       GoogleTest prebuilt), ctest, and one idiff process per frame.
//
// The three take turns, so that a machine which changes its speed changes it for all. CPU time
// counts every child, sandboxed ones too. Prints a row per assignment, (c) for one of them; ratios
// are medians over the rounds' pairs.

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "Error.h"
#include "Process.h"
#include "bench/Edit.h"
#include "bench/Median.h"
#include "bench/Ways.h"

namespace {

using namespace bench;

const std::string kAssignment = "07-camera";  // measured against the usual way, too
class Bench {
public:
    explicit Bench(const std::string& assignment)
        : ways_(assignment), tools_(ways_.tools()), manifest_(ways_.manifest()) {
        submission_ = work_.path() / "submission";
        fs::copy(tools_.root / "solutions", submission_, fs::copy_options::recursive);
        stage_ = ways_.grader().stageOf(manifest_, "solutions");
    }

    static std::vector<std::string> assignments() {
        return knownAssignments(Toolchain::load().root);
    }
    /// The file that is edited: the last one that needs compiling, if any does.
    const std::string& edited() const {
        for (auto name = manifest_.submit.rbegin(); name != manifest_.submit.rend(); ++name)
            if (name->ends_with(".cpp"))
                return *name;
        return manifest_.submit.back();
    }

    /// An edit that changes nothing but the text.
    void edit() {
        const std::string text = stage_.find(edited())->content + editOf(edited(), ++edits_);
        writeFile(submission_ / manifest_.id / edited(), text);
    }

    void bare() { ways_.bare(stage_); }

    void grade() {
        mustRun(
            {(tools_.root / "grade").string(), manifest_.id, "--submission", submission_.string()},
            1);
    }

    void gradeUncached() {
        fs::remove_all(tools_.cache / "objects");
        grade();
    }

    void usualWay() { ways_.usual(stage_); }

private:
    Ways ways_;
    const Toolchain& tools_;
    const Manifest& manifest_;
    WorkFolder work_;
    fs::path submission_;
    Stage stage_;
    int edits_ = 0;
};

double medianOf(const std::vector<Cost>& costs, double Cost::*member) {
    std::vector<double> values;
    for (const Cost& cost : costs)
        values.push_back(cost.*member);
    return median(values);
}

double medianRatio(const std::vector<Cost>& over, const std::vector<Cost>& under,
                   double Cost::*member) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < over.size(); ++i)
        ratios.push_back(over[i].*member / under[i].*member);
    return median(ratios);
}

struct Costs {
    std::vector<Cost> bare, edited, uncached, usual;
};

Costs measureAssignment(Bench& bench, int rounds, bool usualWay) {
    Costs costs;
    bench.grade();  // warms the disk, the references and the cache of provided files
    for (int round = 0; round < rounds; ++round) {
        costs.bare.push_back(measure([&] { bench.bare(); }));
        bench.edit();
        costs.edited.push_back(measure([&] { bench.grade(); }));
        if (usualWay)
            costs.usual.push_back(measure([&] { bench.usualWay(); }));
        bench.edit();
        costs.uncached.push_back(measure([&] { bench.gradeUncached(); }));
        std::cerr << "." << std::flush;
    }
    return costs;
}

void printRow(const std::string& id, const Costs& costs) {
    fmt::print("| {} |", id);
    for (const auto* each : {&costs.bare, &costs.edited, &costs.uncached})
        fmt::print(" {:.2f} | {:.2f} |", medianOf(*each, &Cost::wall), medianOf(*each, &Cost::cpu));
    fmt::print(" {:.2f} | {:.2f} | {:+.2f} |\n", medianRatio(costs.edited, costs.bare, &Cost::wall),
               medianRatio(costs.uncached, costs.bare, &Cost::wall),
               medianOf(costs.uncached, &Cost::cpu) - medianOf(costs.bare, &Cost::cpu));
}

void printUsualWay(const Costs& costs) {
    fmt::print(
        "\n{}, the usual way (c): wall {:.2f} s, CPU {:.2f} s. CPU of (c) / (b): {:.1f} after "
        "an edit, {:.1f} with nothing cached.\n",
        kAssignment, medianOf(costs.usual, &Cost::wall), medianOf(costs.usual, &Cost::cpu),
        medianRatio(costs.usual, costs.edited, &Cost::cpu),
        medianRatio(costs.usual, costs.uncached, &Cost::cpu));
}

}  // namespace

int main(int argc, char** argv) try {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
    if (rounds < 1) {
        std::cerr << "usage: grading_benchmark [ROUNDS]\n";
        return 2;
    }
    const bool withIdiff = run({"idiff", "--help"}, 10.0).exitCode != 127;
    if (!withIdiff)
        std::cout << "idiff is not installed (package openimageio-tools): (c) is left out\n";
    fmt::print(
        "Medians of {} rounds, seconds.\n\n"
        "| assignment | (a) wall | CPU | (b) edited: wall | CPU | (b) uncached: wall | CPU | "
        "wall (b)/(a) edited | uncached | CPU (b) uncached - (a) |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n",
        rounds);
    Costs withUsualWay;
    for (const std::string& id : Bench::assignments()) {
        Bench bench(id);
        const Costs costs = measureAssignment(bench, rounds, withIdiff && id == kAssignment);
        printRow(id, costs);
        std::fflush(stdout);
        if (id == kAssignment)
            withUsualWay = costs;
    }
    if (!withUsualWay.usual.empty())
        printUsualWay(withUsualWay);
    return 0;
} catch (const std::exception& error) {
    std::cerr << "benchmark: " << error.what() << "\n";
    return 2;
}
