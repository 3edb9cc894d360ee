#pragma once

#include <string>
#include <vector>

#include "Grade.h"
#include "course/Findings.h"

namespace grader {

/// That no mark hangs on what draws: programs are drawn once more with EGL and softpipe, Mesa's
/// other rasteriser for CPUs, which shares no code with llvmpipe's, and must be worth the same.
/// (That OSMesa and EGL alone give the same bytes for every solution is a test of its own.)
/// Beside it stands how far the pictures differ, and how much of the frames' budgets (the
/// manifest's "tolerance") right programs use.
class DriverComparison {
public:
    /// All must outlive this.
    DriverComparison(const Toolchain& tools, const Sandbox& sandbox, Manifest manifest,
                     Findings& findings);

    /// `expected`: the checks of `stage` as it is usually graded. Of a right program every check is
    /// repeated, of another the frames.
    void compare(const std::string& program, const Stage& stage,
                 const std::vector<CheckResult>& expected, bool right);

    std::string table() const;

private:
    void compareChecks(const std::string& program, const CheckResult& expected,
                       const CheckResult& found, bool right);

    const Grader other_;
    Manifest manifest_;
    Findings& findings_;
    int programs_ = 0, frames_ = 0, identical_ = 0;
    double mostPixels_ = 0;  ///< share of a frame's pixels that differ at all
    double mostOff_ = 0;     ///< the same by more than a driver's rounding
    double mostScore_ = 0;   ///< change of a check's share of its points
    double used_ = 0;        ///< of a frame's pixels, by right programs
};

}  // namespace grader
