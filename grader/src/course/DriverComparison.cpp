#include "course/DriverComparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace grader {

namespace {

/// Both changed at once: what stays the same depends on neither.
const Renderer kOther{"egl", "softpipe"};

/// What is drawn more slowly is not wrong: softpipe takes up to twenty times as long.
constexpr int kPatience = 20;
/// What a score that is neither everything nor nothing may move by, as under noise
/// (docs/scoring.md).
constexpr double kSameShare = 0.005;

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

/// Where a wrong program draws the very reference, another renderer draws what it draws for the
/// solution, which is compared anyway.
bool isTheReference(const Frame& frame, const std::vector<CheckResult>& checks) {
    const auto check = std::find_if(checks.begin(), checks.end(),
                                    [&](const auto& each) { return each.id == frame.id; });
    return check != checks.end() && check->pictures &&
           check->pictures->submission.rgba == check->pictures->reference.rgba;
}

}  // namespace

DriverComparison::DriverComparison(const Toolchain& tools, const Sandbox& sandbox,
                                   Manifest manifest, Findings& findings)
    : other_(tools, sandbox, kOther), manifest_(std::move(manifest)), findings_(findings) {
    manifest_.limits.callSeconds *= kPatience;
    manifest_.limits.frameSeconds *= kPatience;
}

void DriverComparison::compare(const std::string& program, const Stage& stage,
                               const std::vector<CheckResult>& expected, bool right) {
    ++programs_;
    Manifest worthDrawing = manifest_;
    if (!right)
        std::erase_if(worthDrawing.frames,
                      [&](const Frame& frame) { return isTheReference(frame, expected); });
    const auto found = right ? other_.gradeStage(manifest_, stage, kPublishedSeed).checks
                             : other_.gradeFrames(worthDrawing, stage, kPublishedSeed);
    for (const CheckResult& check : found)
        compareChecks(program,
                      *std::find_if(expected.begin(), expected.end(),
                                    [&](const auto& each) { return each.id == check.id; }),
                      check, right);
}

void DriverComparison::compareChecks(const std::string& program, const CheckResult& expected,
                                     const CheckResult& found, bool right) {
    const double moved =
        expected.maxPoints > 0 ? std::abs(expected.points - found.points) / expected.maxPoints : 0;
    mostScore_ = std::max(mostScore_, moved);
    if (moved > kSameShare || expected.status != found.status)
        findings_.add(
            fmt::format("{}: {} is {} with {:g} points, and {} with {:g} by {} {}: {}", program,
                        expected.id, judge::toString(expected.status), expected.points,
                        judge::toString(found.status), found.points, kOther.context, kOther.driver,
                        found.message.empty() ? expected.message : found.message),
            "make the check's tolerance hold what drivers differ by");
    if (!expected.pictures || !found.pictures)
        return;
    const Picture &a = expected.pictures->submission, &b = found.pictures->submission;
    if (!a.sameSizeAs(b) || a.empty())
        return;
    const double pixels = shareDifferent(a, b), off = outlierShare(a, b);
    ++frames_;
    identical_ += pixels == 0 ? 1 : 0;
    mostPixels_ = std::max(mostPixels_, pixels);
    mostOff_ = std::max(mostOff_, off);
    if (!right)
        return;
    used_ = std::max(used_, off);
    if (expected.maxPoints > 0)  // else the picture is the student's choice
        used_ = std::max(used_, found.pictures->score.outliers);
}

std::string DriverComparison::table() const {
    double budget = 0;
    for (const Frame& frame : manifest_.frames)
        budget = std::max(budget, frame.tolerance);
    return fmt::format(
        "{} {}: {} programs, {} frames, {} of them identical; at most {:.3f} % of a frame's "
        "pixels differ, {:.3f} % by more than rounding; no check's score moves by more than "
        "{:.3f} %; right programs use {:.4f} % of a frame's pixels, budget {:.2f} %\n",
        kOther.context, kOther.driver, programs_, frames_, identical_, 100 * mostPixels_,
        100 * mostOff_, 100 * mostScore_, 100 * used_, 100 * budget);
}

}  // namespace grader
