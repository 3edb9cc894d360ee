// How long a student waits, measured side by side in one run.
//
//   (a) the bare cost of the same files: plain compiler calls, all files at once, a link, and the
//       runner without sandbox drawing the frames. No check is made.
//   (e) the same after an edit of one file, the objects of all others being there: what a good
//       build tool and a window would take.
//   (w) `./grade --watch ASSIGNMENT` in a terminal: from a save of one file, by rename, until the
//       verdict is on the screen.
//
// The three take turns, so that a machine which changes its speed changes it for all. Each round
// saves another text, so that nothing comes out of a cache. Ratios are medians over the rounds'
// pairs.

#include <cstdlib>
#include <iostream>

#include "Error.h"
#include "bench/Edit.h"
#include "bench/Median.h"
#include "bench/Ways.h"
#include "testing/PseudoTerminal.h"

namespace {

using namespace bench;

const std::vector<std::string> kAssignments = {"06-rotation", "07-camera", "10-lighting"};

/// The end of the line with the keys: the watch waits for a save.
const std::string kWaiting = "q quit";

struct Walls {
    std::vector<double> bare, edited, watch;
};

class Bench {
public:
    explicit Bench(const std::string& assignment)
        : ways_(assignment),
          manifest_(ways_.manifest()),
          stage_(ways_.grader().stageOf(manifest_, "solutions")) {
        fs::copy(ways_.tools().root / "solutions", submission(), fs::copy_options::recursive);
        terminal_ = std::make_unique<testing_help::PseudoTerminal>(std::vector<std::string>{
            COURSE_GRADER, "--watch", assignment, "--submission", submission().string()});
        terminal_->waitFor(kWaiting, 120);
    }

    Walls measureRounds(int rounds) {
        Walls walls;
        for (int round = 0; round < rounds; ++round) {
            edit(round);
            walls.bare.push_back(measure([&] { ways_.bare(stage_); }).wall);
            walls.edited.push_back(measure([&] { ways_.bareAgain(stage_, edited()); }).wall);
            walls.watch.push_back(measure([&] { saveAndWait(); }).wall);
            terminal_->waitFor(kWaiting);
            std::cerr << "." << std::flush;
        }
        return walls;
    }

private:
    fs::path submission() const { return work_.path() / "submission"; }

    /// The file that is edited: the last one that needs compiling, if any does.
    const std::string& edited() const {
        for (auto name = manifest_.submit.rbegin(); name != manifest_.submit.rend(); ++name)
            if (name->ends_with(".cpp"))
                return *name;
        return manifest_.submit.back();
    }
    void edit(int round) { stage_.find(edited())->content += editOf(edited(), round); }

    void saveAndWait() {
        writeFile(submission() / manifest_.id / edited(), stage_.find(edited())->content);
        terminal_->waitFor("100 / 100");
    }

    Ways ways_;
    const Manifest& manifest_;
    Stage stage_;
    WorkFolder work_;
    std::unique_ptr<testing_help::PseudoTerminal> terminal_;
};

double medianRatio(const std::vector<double>& over, const std::vector<double>& under) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < over.size(); ++i)
        ratios.push_back(over[i] / under[i]);
    return median(ratios);
}

}  // namespace

int main(int argc, char** argv) try {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
    if (rounds < 1) {
        std::cerr << "usage: watch_benchmark [ROUNDS]\n";
        return 2;
    }
    fmt::print(
        "Medians of {} rounds, seconds of wall time.\n\n"
        "| assignment | (a) bare | (e) bare, one file | (w) save to verdict | (w)/(a) | (w)/(e) |\n"
        "|---|---|---|---|---|---|\n",
        rounds);
    for (const std::string& id : kAssignments) {
        const Walls walls = Bench(id).measureRounds(rounds);
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", id, median(walls.bare),
                   median(walls.edited), median(walls.watch), medianRatio(walls.watch, walls.bare),
                   medianRatio(walls.watch, walls.edited));
        std::fflush(stdout);
    }
    return 0;
} catch (const std::exception& error) {
    std::cerr << "benchmark: " << error.what() << "\n";
    return 2;
}
