// What scoring one frame of 800x600 costs in CPU time, with references loaded, beside reading the
// two PNGs and beside one idiff process (package openimageio-tools) on the same pair. All take
// turns within each round; ratios are medians over the rounds. Argument: the number of rounds.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iostream>

#include "Error.h"
#include "Files.h"
#include "ImageModule.h"
#include "Process.h"
#include "bench/Median.h"
#include "compare/FrameScore.h"
#include "compare_tests/Pictures.h"

namespace {

using namespace grader;

double cpuOf(const std::function<void()>& work) {
    const double before = cpuSeconds();
    work();
    return cpuSeconds() - before;
}

struct Row {
    const char* name;
    std::function<void()> work;
    std::vector<double> cpu;
};

/// A scene without anything that stands before a background: no shift is searched in it.
trial::Scene withoutObjects() {
    trial::Scene scene = trial::scenes().front();
    scene.things.insert(scene.things.begin() + 1, {400, 300, 700, {200, 180, 160}});
    std::swap(scene.things[0], scene.things[1]);
    return scene;
}

/// A picture of the scene with its small thing painted wrongly.
Picture paintedSecond(trial::Scene scene) {
    std::swap(scene.things[1].colour[0], scene.things[1].colour[2]);
    return trial::draw(scene);
}

int bench(int rounds) {
    const trial::Scene scene = trial::scenes().front();
    const Picture reference = trial::draw(scene), wrong = trial::moved(scene, 56);
    const FrameRule withSearch({reference, {trial::starterOf(scene)}, {}, 0.0005});
    const FrameRule withFeature({reference,
                                 {trial::starterOf(scene)},
                                 {{"first", "the first thing", trial::without(scene)}},
                                 0.0005});
    const trial::Scene crowded = withoutObjects();
    const Picture crowdedWrong = paintedSecond(crowded);
    const FrameRule withoutSearch({trial::draw(crowded), {trial::starterOf(crowded)}, {}, 0.0005});

    const WorkFolder folder;
    const fs::path mine = folder.path() / "submission.png", right = folder.path() / "reference.png";
    writePicture(mine, wrong);
    writePicture(right, reference);
    const auto idiff = [&] {
        const auto result = run({"idiff", "-q", mine.string(), right.string()}, 60);
        if (result.exitCode < 0 || result.exitCode > 2)
            throw Error("idiff did not run (package openimageio-tools):\n{}", result.output);
    };
    std::vector<Row> rows = {
        {"right frame", [&] { withSearch.score(reference); }, {}},
        {"wrong frame, no shift searched", [&] { withoutSearch.score(crowdedWrong); }, {}},
        {"wrong frame, shift searched", [&] { withSearch.score(wrong); }, {}},
        {"wrong frame, with a feature, too", [&] { withFeature.score(wrong); }, {}},
        {"reading the two PNGs", [&] { readPicture(mine), readPicture(right); }, {}},
        {"one idiff process", idiff, {}},
    };
    for (const Row& row : rows)
        row.work();  // references prepared, libraries loaded
    for (int round = 0; round < rounds; ++round) {
        rows[2].work();  // takes the copies of pages that forking for idiff left behind
        for (Row& row : rows)
            row.cpu.push_back(cpuOf(row.work));
    }

    const Row& reading = rows[4];
    const Row& process = rows[5];
    const auto ratio = [&](const Row& over, const Row& under) {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < over.cpu.size(); ++i)
            ratios.push_back(over.cpu[i] / under.cpu[i]);
        return median(ratios);
    };
    fmt::print("| | CPU, ms | of reading | idiff takes |\n|---|---|---|---|\n");
    for (const Row& row : rows)
        fmt::print("| {} | {:.1f} | {:.2f} x | {:.1f} x |\n", row.name, 1000 * median(row.cpu),
                   ratio(row, reading), ratio(process, row));
    fmt::print("\nWanted: at most 40 ms without and 150 ms with the search, idiff at least 8 x.\n");
    return 0;
}

}  // namespace

int main(int argc, char** argv) try {
    return bench(argc > 1 ? std::max(1, std::stoi(argv[1])) : 15);
} catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
}
