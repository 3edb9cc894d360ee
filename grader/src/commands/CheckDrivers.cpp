// That no mark hangs on what draws: the frames of every solution, variant and mistake are drawn
// with both of Mesa's drivers for CPUs and with both kinds of contexts, and must be worth the same;
// right programs are tested with each, too. Beside it stands how far the pictures differ, and how
// much of the frames' budgets (the manifest's "tolerance") right programs use.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "Error.h"
#include "Grade.h"
#include "Mistakes.h"
#include "commands/CourseCommands.h"
#include "commands/GradeCommand.h"
#include "course/Findings.h"

namespace grader {

namespace {

const Renderer kUsual{"osmesa", "llvmpipe"};
/// Both changed at once: what stays the same depends on neither. That OSMesa and EGL alone give the
/// same bytes for every solution is a test of its own.
const Renderer kOther{"egl", "softpipe"};

/// What is drawn more slowly is not wrong: softpipe takes up to twenty times as long.
constexpr int kPatience = 20;
/// What a score that is neither everything nor nothing may move by, as under noise
/// (docs/scoring.md).
constexpr double kSameShare = 0.005;

struct Options {
    std::vector<std::string> assignments;
    std::string only;
};

std::string nameOf(const Renderer& renderer) {
    return renderer.context + " " + renderer.driver;
}

/// What another renderer made of the programs.
struct Difference {
    int frames = 0, identical = 0;
    double mostPixels = 0;  ///< share of a frame's pixels that differ at all
    double mostOff = 0;     ///< the same by more than a driver's rounding
    double mostScore = 0;   ///< change of a check's share of its points
};

double shareDifferent(const Picture& a, const Picture& b) {
    double different = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        different +=
            std::equal(a.rgba.begin() + std::ptrdiff_t(i), a.rgba.begin() + std::ptrdiff_t(i) + 3,
                       b.rgba.begin() + std::ptrdiff_t(i))
                ? 0
                : 1;
    return 4 * different / static_cast<double>(a.rgba.size());
}

class DriverCheck {
public:
    DriverCheck(const Toolchain& tools, const Sandbox& sandbox, const std::string& id)
        : usual_(tools, sandbox, kUsual),
          other_(tools, sandbox, kOther),
          manifest_(loadAssignment(tools.root, id)) {
        manifest_.limits.callSeconds *= kPatience;
        manifest_.limits.frameSeconds *= kPatience;
    }

    int run(const std::string& only) {
        const fs::path folder = usual_.tools().root / "solutions" / manifest_.id;
        const Stage solution = usual_.stageOf(manifest_, "solutions");
        const auto wanted = [&](const std::string& name) {
            return name.find(only) != std::string::npos;
        };
        if (wanted("solution"))
            compare("solution", solution, true);
        for (const fs::path& variant : variantsOf(folder)) {
            Stage stage = solution;
            layOver(stage, variant);
            if (const std::string name = variant.filename().string(); wanted(name))
                compare(name, stage, !fs::exists(variant / "loses.json"));
        }
        for (const Mistake& mistake : readMistakes(folder))
            if (wanted(mistake.id))
                compare(mistake.id, stageWith(solution, mistake, mistake.body), false);
        if (programs_ == 0)
            throw Error("no program of {} has \"{}\" in its name", manifest_.id, only);
        print();
        return findings_.count();
    }

private:
    void compare(const std::string& program, const Stage& stage, bool right) {
        ++programs_;
        const auto expected = checksOf(usual_, stage, right);
        if (expected.empty())
            findings_.add(program + " does not compile, or has no frame", "look at check-course");
        const auto found = checksOf(other_, stage, right);
        for (std::size_t i = 0; i < expected.size(); ++i)
            compareChecks(program, expected.at(i), found.at(i), right);
    }

    std::vector<CheckResult> checksOf(const Grader& grader, const Stage& stage, bool right) const {
        return right ? grader.gradeStage(manifest_, stage, kPublishedSeed).checks
                     : grader.gradeFrames(manifest_, stage, kPublishedSeed);
    }

    void compareChecks(const std::string& program, const CheckResult& expected,
                       const CheckResult& found, bool right) {
        const double moved = expected.maxPoints > 0
                                 ? std::abs(expected.points - found.points) / expected.maxPoints
                                 : 0;
        difference_.mostScore = std::max(difference_.mostScore, moved);
        if (moved > kSameShare || expected.status != found.status)
            findings_.add(fmt::format("{}: {} is {} with {:g} points by {}, and {} with {:g} by "
                                      "{}: {}",
                                      program, expected.id, judge::toString(expected.status),
                                      expected.points, nameOf(kUsual),
                                      judge::toString(found.status), found.points, nameOf(kOther),
                                      found.message.empty() ? expected.message : found.message),
                          "make the check's tolerance hold what drivers differ by");
        if (!expected.pictures || !found.pictures)
            return;
        const Picture &a = expected.pictures->submission, &b = found.pictures->submission;
        if (!a.sameSizeAs(b) || a.empty())
            return;
        const double pixels = shareDifferent(a, b), off = outlierShare(a, b);
        ++difference_.frames;
        difference_.identical += pixels == 0 ? 1 : 0;
        difference_.mostPixels = std::max(difference_.mostPixels, pixels);
        difference_.mostOff = std::max(difference_.mostOff, off);
        if (!right)
            return;
        used_ = std::max(used_, off);
        if (expected.maxPoints > 0)  // else the picture is the student's choice
            used_ = std::max(used_, found.pictures->score.outliers);
    }

    void print() const {
        std::cout << fmt::format("{:<14} {:>4} programs {:>7} {:>10} {:>10} {:>8} {:>8}\n",
                                 manifest_.id, programs_, "frames", "identical", "differ", "off",
                                 "score");
        std::cout << fmt::format("  {:<26} {:>7} {:>10} {:>8.3f} % {:>6.3f} % {:>6.3f} %\n",
                                 nameOf(kOther), difference_.frames, difference_.identical,
                                 100 * difference_.mostPixels, 100 * difference_.mostOff,
                                 100 * difference_.mostScore);
        double budget = 0;
        for (const Frame& frame : manifest_.frames)
            budget = std::max(budget, frame.tolerance);
        std::cout << fmt::format(
            "  right programs use {:.4f} % of a frame's pixels, budget {:.2f} "
            "%\n{}: {} findings\n",
            100 * used_, 100 * budget, manifest_.id, findings_.count());
    }

    const Grader usual_;
    const Grader other_;
    Manifest manifest_;
    int programs_ = 0;
    Difference difference_;
    double used_ = 0;
    Findings findings_;
};

}  // namespace

void addCheckDriversCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command = app.add_subcommand(
        "check-drivers", "prove that programs get the same points whatever draws their frames");
    command->add_option("assignments", options.assignments, "default all");
    command->add_option("--only", options.only, "only programs whose name holds this text");
    command->callback([&exitCode] {
        const Toolchain tools = Toolchain::load();
        const auto sandbox = chooseSandbox(tools.confine());
        int findings = 0;
        for (const std::string& id :
             options.assignments.empty() ? knownAssignments(tools.root) : options.assignments)
            findings += DriverCheck(tools, *sandbox, id).run(options.only);
        exitCode = findings ? kSomethingLost : kFullMarks;
    });
}

}  // namespace grader
