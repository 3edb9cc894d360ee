// What grading a class costs, measured side by side in one run.
//
//     batch_benchmark [COUNT [USUAL [ASSIGNMENT...]]]
//                                       COUNT submissions of each assignment (07-camera and
//                                       10-lighting), in blocks of twenty that take turns with the
//                                       bare cost of the same; USUAL of them the usual way, too
//     batch_benchmark --scale COUNT     one batch of COUNT of 06-rotation, with time and memory as
//                                       it goes on, and a plot of both
//
// CPU time counts every child, sandboxed ones too.

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <iostream>
#include <thread>

#include "Error.h"
#include "bench/Median.h"
#include "bench/Ways.h"

namespace {

using namespace bench;

constexpr std::size_t kBlock = 20;

std::vector<std::string> batchCommand(const fs::path& submissions, const std::string& assignment,
                                      const fs::path& out) {
    return {COURSE_GRADER, "batch",   submissions.string(), "--assignment",
            assignment,    "--out",   out.string(),         "--quiet",
            "--seed",      "20261103"};
}

void makeClass(const std::string& assignment, std::size_t count, unsigned seed,
               const fs::path& folder) {
    mustRun(
        {CLASS_MAKER, assignment, std::to_string(count), std::to_string(seed), folder.string()});
}

struct Sums {
    Cost bare, batch, again, usual;
    std::size_t usualCount = 0;
};

void add(Cost& sum, const Cost& more) {
    sum.wall += more.wall;
    sum.cpu += more.cpu;
}

Sums measureClass(const std::string& assignment, std::size_t count, std::size_t usualCount) {
    Ways ways(assignment);
    const WorkFolder work;
    Sums sums;
    for (std::size_t done = 0, block = 0; done < count; done += kBlock, ++block) {
        const fs::path folder = work.path() / fmt::format("class{}", block),
                       out = work.path() / fmt::format("out{}", block);
        makeClass(assignment, std::min(kBlock, count - done), static_cast<unsigned>(block), folder);
        fs::remove_all(ways.tools().cache / "objects");  // as for code that was never seen
        add(sums.batch, measure([&] { mustRun(batchCommand(folder, assignment, out)); }));
        add(sums.again, measure([&] { mustRun(batchCommand(folder, assignment, out)); }));
        for (const auto& entry : fs::directory_iterator(folder)) {
            const Stage stage =
                collect(ways.tools().root, ways.manifest(), {entry.path(), true}).stage;
            add(sums.bare, measure([&] { ways.bare(stage); }));
            if (sums.usualCount < usualCount) {
                ++sums.usualCount;
                add(sums.usual, measure([&] { ways.usual(stage); }));
            }
        }
        std::cerr << "." << std::flush;
    }
    return sums;
}

void compare(std::size_t count, std::size_t usualCount,
             const std::vector<std::string>& assignments) {
    fmt::print(
        "{} submissions of each, seconds of CPU for each submission; the usual way on {} of "
        "them.\n\n| assignment | bare | batch | batch / bare | the usual way | usual / batch | "
        "again, nothing changed | again / first |\n|---|---|---|---|---|---|---|---|\n",
        count, usualCount);
    for (const std::string& assignment : assignments) {
        const Sums sums = measureClass(assignment, count, usualCount);
        const double n = static_cast<double>(count);
        const double usual =
            sums.usualCount ? sums.usual.cpu / static_cast<double>(sums.usualCount) : 0.0;
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} | {:.3f} | {:.2f} % |\n",
                   assignment, sums.bare.cpu / n, sums.batch.cpu / n,
                   sums.batch.cpu / sums.bare.cpu, usual, usual / (sums.batch.cpu / n),
                   sums.again.cpu / n, 100 * sums.again.cpu / sums.batch.cpu);
        std::fflush(stdout);
    }
}

struct Sample {
    std::size_t done;
    double seconds, memoryMib;
};

/// The most memory that a process has had, MiB; of the process alone, without its children.
double peakMemoryOf(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/status");
    for (std::string word; file >> word;)
        if (word == "VmHWM:") {
            double kib = 0;
            file >> kib;
            return kib / 1024;
        }
    return 0;
}

std::size_t finishedIn(const fs::path& out) {
    std::size_t count = 0;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(out / "students", none))
        count += fs::exists(entry.path() / "key");
    return count;
}

std::vector<Sample> watch(const fs::path& submissions, const fs::path& out, std::size_t count) {
    auto command = batchCommand(submissions, "06-rotation", out);
    std::vector<char*> argv;
    for (std::string& each : command)
        argv.push_back(each.data());
    argv.push_back(nullptr);
    const auto start = std::chrono::steady_clock::now();
    const pid_t process = fork();
    if (process == 0) {
        execv(argv[0], argv.data());
        _exit(127);
    }
    std::vector<Sample> samples;
    std::size_t next = 50;
    double memory = 0;
    while (waitpid(process, nullptr, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        memory = std::max(memory, peakMemoryOf(process));
        const std::size_t done = finishedIn(out);
        if (done < next)
            continue;
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        samples.push_back({done, seconds, memory});
        next = done < count ? std::min(count, done + std::max<std::size_t>(50, count / 20))
                            : count + 1;
    }
    if (next > count)
        return samples;
    samples.push_back(
        {finishedIn(out),
         std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), memory});
    return samples;
}

/// Two curves over the number of submissions, each scaled to its largest value.
std::string plotOf(const std::vector<Sample>& samples) {
    constexpr double kWidth = 640, kHeight = 320, kLeft = 60, kBottom = 40;
    const Sample& last = samples.back();
    const auto curve = [&](auto&& valueOf, double most, const char* colour) {
        std::string points;
        for (const Sample& each : samples)
            points +=
                fmt::format("{:.1f},{:.1f} ",
                            kLeft + (kWidth - 2 * kLeft) * double(each.done) / double(last.done),
                            kHeight - kBottom - (kHeight - 2 * kBottom) * valueOf(each) / most);
        return fmt::format(
            "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"2\" points=\"{}\"/>\n", colour,
            points);
    };
    const double memoryTop = 300;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" "
        "font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
        "<path d=\"M{2} {3}V{4}H{5}V{3}\" fill=\"none\" stroke=\"#888\"/>\n{6}{7}"
        "<text x=\"{2}\" y=\"30\" fill=\"#1f5f9f\">time, at the top {8:.0f} s</text>\n"
        "<text x=\"{5}\" y=\"30\" text-anchor=\"end\" fill=\"#b4530f\">peak memory of the grader, "
        "at "
        "the top {9:.0f} MiB</text>\n<text x=\"{2}\" y=\"{10}\">0</text>\n<text x=\"{5}\" "
        "y=\"{10}\" "
        "text-anchor=\"end\">{11} submissions</text>\n</svg>\n",
        kWidth, kHeight, kLeft, kBottom, kHeight - kBottom, kWidth - kLeft,
        curve([](const Sample& each) { return each.seconds; }, last.seconds, "#1f5f9f"),
        curve([](const Sample& each) { return each.memoryMib; }, memoryTop, "#b4530f"),
        last.seconds, memoryTop, kHeight - 20, last.done);
}

void scale(std::size_t count) {
    const WorkFolder work;
    makeClass("06-rotation", count, 1, work.path() / "class");
    const auto samples = watch(work.path() / "class", work.path() / "out", count);
    fmt::print(
        "| submissions | seconds | seconds for each | peak memory of the grader, MiB |\n"
        "|---|---|---|---|\n");
    for (const Sample& each : samples)
        fmt::print("| {} | {:.0f} | {:.3f} | {:.0f} |\n", each.done, each.seconds,
                   each.seconds / double(each.done), each.memoryMib);
    writeFile("batch-scale.svg", plotOf(samples));
    fmt::print("\nPlot: batch-scale.svg\n");
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc == 3 && std::string(argv[1]) == "--scale")
        scale(std::stoul(argv[2]));
    else if (argc > 1 && !std::isdigit(static_cast<unsigned char>(*argv[1])))
        throw Error("usage: batch_benchmark [COUNT [USUAL [ASSIGNMENT...]]] | --scale COUNT");
    else
        compare(argc > 1 ? std::stoul(argv[1]) : 200, argc > 2 ? std::stoul(argv[2]) : 5,
                argc > 3 ? std::vector<std::string>(argv + 3, argv + argc)
                         : std::vector<std::string>{"07-camera", "10-lighting"});
    return 0;
} catch (const std::exception& error) {
    std::cerr << "benchmark: " << error.what() << "\n";
    return 2;
}
