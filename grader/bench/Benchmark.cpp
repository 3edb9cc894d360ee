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
#include <chrono>
#include <cstdlib>
#include <functional>
#include <future>
#include <iostream>

#include "Error.h"
#include "Grade.h"
#include "ImageModule.h"
#include "Process.h"
#include "bench/Median.h"

namespace {

using namespace grader;

const std::string kAssignment = "07-camera";  // measured against the usual way, too
constexpr double kPatience = 300.0;           // seconds for one command

struct Cost {
    double wall = 0, cpu = 0;
};

Cost measure(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const double cpu = cpuSeconds();
    work();
    const double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return {wall, cpuSeconds() - cpu};
}

void mustRun(const std::vector<std::string>& command, int worstExitCode = 0) {
    const ProcessResult result = run(command, kPatience);
    if (result.timedOut || result.exitCode < 0 || result.exitCode > worstExitCode)
        throw Error("{} failed:\n{}", fmt::join(command, " "), result.output);
}

class Bench {
public:
    explicit Bench(const std::string& assignment)
        : tools_(Toolchain::load()),
          manifest_(loadAssignment(tools_.root, assignment)),
          plain_(makePlainProcess(tools_.confine())),
          observer_(tools_, *plain_, {}),
          grader_(tools_, *plain_) {
        submission_ = work_.path() / "submission";
        fs::copy(tools_.root / "solutions", submission_, fs::copy_options::recursive);
        stage_ = grader_.stageOf(manifest_, "solutions");
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
        const std::string text =
            stage_.find(edited())->content + fmt::format("// edit {}\n", ++edits_);
        writeFile(submission_ / manifest_.id / edited(), text);
    }

    void bare() {
        const fs::path folder = work_.path() / "bare";
        fs::remove_all(folder);
        std::vector<std::future<void>> compiling;
        std::vector<std::string> link = {tools_.compiler};
        link.insert(link.end(), tools_.linkFlags.begin(), tools_.linkFlags.end());
        for (const StagedFile& file : stage_.files)
            writeFile(folder / file.name, file.content);
        for (const StagedFile& file : stage_.files) {
            if (!file.name.ends_with(".cpp"))
                continue;
            const std::string object = (folder / file.name).string() + ".o";
            link.push_back(object);
            std::vector<std::string> command = {tools_.compiler};
            command.insert(command.end(), tools_.compileFlags.begin(), tools_.compileFlags.end());
            for (const std::string& each :
                 {std::string("-include"), (tools_.kit / "prelude/prelude.h").string(),
                  "-I" + (tools_.kit / "include").string(), "-I" + folder.string(),
                  std::string("-c"), (folder / file.name).string(), std::string("-o"), object})
                command.push_back(each);
            compiling.push_back(std::async(std::launch::async, [command] { mustRun(command); }));
        }
        for (auto& each : compiling)
            each.get();
        BuildResult build;
        build.ok = true;
        build.stage = folder;
        build.user = user_.id();
        build.object = folder / "subject.so";
        link.insert(link.end(),
                    {(tools_.kit / "lib/libcg.a").string(), "-o", build.object.string()});
        mustRun(link);
        shareWithSandbox(folder, user_.id(), false);
        observer_.drawFrames(manifest_, build, 1);
    }

    void grade() {
        mustRun(
            {(tools_.root / "grade").string(), manifest_.id, "--submission", submission_.string()},
            1);
    }

    void gradeUncached() {
        fs::remove_all(tools_.cache / "objects");
        grade();
    }

    void usualWay() {
        const fs::path folder = work_.path() / "usual";
        fs::remove_all(folder);
        fs::copy(fs::path(COURSE_BENCH) / "usual_way", folder, fs::copy_options::recursive);
        for (const StagedFile& file : stage_.files)
            writeFile(folder / file.name, file.content);
        const std::string build = (folder / "build").string();
        mustRun({"cmake", "-S", folder.string(), "-B", build, "-G", "Ninja",
                 "-DCMAKE_BUILD_TYPE=Release", "-DCOURSE_ROOT=" + tools_.root.string(),
                 "-DCOURSE_BUILD=" + tools_.build.string(), "-DASSIGNMENT=" + kAssignment});
        mustRun({"cmake", "--build", build});
        mustRun({"ctest", "--test-dir", build}, 8);
        const std::string frames = (folder / "frames").string();
        fs::create_directories(frames);
        mustRun({"sh", "-c", "cd " + folder.string() + " && build/render " + frames});
        for (const Frame& frame : manifest_.frames)
            mustRun(
                {"idiff", "-fail", "0.016", "-failpercent", "0.05",
                 frames + "/" + frame.id + ".png",
                 (tools_.root / "reference_images" / kAssignment / (frame.id + ".png")).string()},
                2);
    }

private:
    Toolchain tools_;
    Manifest manifest_;
    std::unique_ptr<Sandbox> plain_;
    Observer observer_;
    Grader grader_;
    WorkFolder work_;
    JobUser user_;
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
