// How well mistakes are recognised, measured on what their signatures were not made from: a second,
// independently written version of each, with another seed; and pairs of them. That right programs
// are not accused is part of check-course: they lose nothing.

#include <fmt/format.h>
#include <numeric>

#include <algorithm>
#include <iostream>

#include "Error.h"
#include "ExitCode.h"
#include "Grade.h"
#include "Mistakes.h"
#include "commands/CourseCommands.h"
#include "course/Findings.h"
#include "course/NewAssignment.h"

namespace grader {

namespace {

constexpr std::uint64_t kOtherSeed = 2;
constexpr double kLeastNamed = 0.95;
constexpr double kMostWrong = 0.05;
constexpr std::size_t kPairs = 12;

struct Options {
    std::vector<std::string> assignments;
    std::string only;
};

/// How often a name was right.
struct Tally {
    int all = 0, named = 0, together = 0, silent = 0, wrong = 0;

    /// `made`: the mistakes that are in the code.
    void count(const std::optional<Recognised>& said, const std::set<std::string>& made) {
        ++all;
        if (!said) {
            ++silent;
            return;
        }
        const auto& ids = said->mistakes;
        const bool right = std::any_of(ids.begin(), ids.end(),
                                       [&](const std::string& id) { return made.contains(id); });
        ++(!right ? wrong : ids.size() > 1 ? together : named);
    }
    double shareRight() const { return all ? double(named + together) / all : 1.0; }
    double shareWrong() const { return all ? double(wrong) / all : 0.0; }
};

class RecognitionCheck {
public:
    RecognitionCheck(const Grader& grader, const std::string& id)
        : grader_(grader),
          manifest_(loadAssignment(grader.tools().root, id)),
          solution_(grader.stageOf(manifest_, "solutions")),
          mistakes_(readMistakes(grader.tools().root / "solutions" / id)) {}

    int run(const std::string& only) {
        std::erase_if(mistakes_,
                      [&](const Mistake& each) { return each.id.find(only) == std::string::npos; });
        if (mistakes_.empty())
            throw Error("no mistake of {} has \"{}\" in its id", manifest_.id, only);
        for (const Mistake& mistake : mistakes_)
            checkSecond(mistake);
        if (only.empty())
            checkPairs();
        judgeTallies();
        print();
        return findings_.count();
    }

private:
    /// The tasks of a submission, as a student's report would show them.
    std::vector<TaskResult> graded(Stage stage, const std::string& what) {
        AssignmentResult result = grader_.gradeStaged(manifest_, stage, kOtherSeed);
        if (!result.buildOk)
            findings_.add(what + " does not compile: " + result.diagnostics.front().message,
                          "edit it in solutions/" + manifest_.id);
        return result.tasks;
    }

    void checkSecond(const Mistake& mistake) {
        const std::string what = "second version of " + mistake.id;
        if (mistake.second.empty()) {
            findings_.add(
                "mistake " + mistake.id + " has no second version",
                "write solutions/" + manifest_.id + "/mistakes/second/" + mistake.fileName());
            return;
        }
        std::vector<CheckResult> checks;
        for (const TaskResult& task : graded(stageWith(solution_, mistake, mistake.second), what)) {
            checks.insert(checks.end(), task.checks.begin(), task.checks.end());
            if (task.id != mistake.region)
                continue;
            seconds_.count(task.recognised, {mistake.id});
            tell(mistake.id, task.recognised, {mistake.id});
        }
        for (const std::string& each : unexpectedLosses(mistake, checks))
            findings_.add("second version: " + each, "edit solutions/" + manifest_.id +
                                                         "/mistakes/second/" + mistake.fileName());
    }

    /// Two mistakes of different regions, in their second versions: in each task that loses, one of
    /// the two is named, or nothing is said.
    void checkPairs() {
        std::size_t made = 0;
        const std::size_t all = mistakes_.size();
        std::size_t stride = 5;
        while (all > 0 && std::gcd(stride, all) > 1)
            ++stride;  // so that no pair comes twice
        for (std::size_t step = 1; step < all && made < kPairs; ++step) {
            const Mistake& one = mistakes_[step * stride % all];
            const Mistake& other = mistakes_[(step * stride + all / 2) % all];
            if (one.region == other.region || one.second.empty() || other.second.empty())
                continue;
            ++made;
            const std::string what = one.id + " with " + other.id;
            const Stage stage =
                stageWith(stageWith(solution_, one, one.second), other, other.second);
            for (const TaskResult& task : graded(stage, what))
                if (one.loses.contains(task.id) || other.loses.contains(task.id)) {
                    pairs_.count(task.recognised, {one.id, other.id});
                    tell(what + " in " + task.id, task.recognised, {one.id, other.id});
                }
        }
    }

    void judgeTallies() {
        const std::string mend = "look at the names above that are wrong or missing";
        if (seconds_.shareRight() < kLeastNamed)
            findings_.add(fmt::format("{:.1f} % of the mistakes are named rightly, wanted {:.0f} %",
                                      100 * seconds_.shareRight(), 100 * kLeastNamed),
                          mend);
        if (pairs_.shareWrong() > kMostWrong)
            findings_.add(fmt::format("{:.1f} % of what pairs lose is named wrongly, wanted at "
                                      "most {:.0f} %",
                                      100 * pairs_.shareWrong(), 100 * kMostWrong),
                          mend);
    }

    void print() const {
        for (const std::string& line : told_)
            std::cout << "  " << line << "\n";
        const auto row = [&](const char* what, const Tally& tally) {
            std::cout << fmt::format("{:<14} {:<8} {:>4} {:>6} {:>9} {:>7} {:>6}\n", manifest_.id,
                                     what, tally.all, tally.named, tally.together, tally.silent,
                                     tally.wrong);
        };
        std::cout << fmt::format("{:<14} {:<8} {:>4} {:>6} {:>9} {:>7} {:>6}\n", "", "", "all",
                                 "named", "together", "silent", "wrong");
        row("mistakes", seconds_);
        row("pairs", pairs_);
        std::cout << fmt::format("{:<14} {} findings\n", manifest_.id, findings_.count());
    }

    /// Keeps what is not plainly right, to be looked at.
    void tell(const std::string& what, const std::optional<Recognised>& said,
              const std::set<std::string>& made) {
        if (said && said->mistakes.size() == 1 && made.contains(said->mistakes.front()))
            return;
        told_.push_back(what + ": " +
                        (said ? fmt::format("{} — {}", fmt::join(said->mistakes, ", "), said->says)
                              : "nothing is said"));
    }

    const Grader& grader_;
    const Manifest manifest_;
    const Stage solution_;
    std::vector<Mistake> mistakes_;
    Findings findings_;
    Tally seconds_, pairs_;
    std::vector<std::string> told_;
};

}  // namespace

void addCheckRecognitionCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command = app.add_subcommand(
        "check-recognition", "measure how mistakes are recognised when others make them");
    command->add_option("assignments", options.assignments, "default all");
    command->add_option("--only", options.only, "only mistakes whose id holds this text");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        requireSolutions(tools.root);
        const auto sandbox = chooseSandbox(tools.confine());
        const Grader grader(tools, *sandbox);
        int findings = 0;
        for (const std::string& id :
             options.assignments.empty() ? knownAssignments(tools.root) : options.assignments)
            findings += RecognitionCheck(grader, id).run(options.only);
        exitCode = findings ? kSomethingLost : kFullMarks;
    });
}

}  // namespace grader
