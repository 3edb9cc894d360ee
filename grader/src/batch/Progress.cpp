#include "batch/Progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "report/PlainText.h"

namespace grader {

Progress::Progress(std::size_t all, bool quiet)
    : all_(all),
      quiet_(quiet),
      changing_(isatty(STDERR_FILENO)),
      start_(std::chrono::steady_clock::now()) {}

void Progress::count(const std::string& what, bool failed, bool fromBefore) {
    ++done_;
    graded_ += fromBefore ? 0 : 1;
    failed_ += failed ? 1 : 0;
    if (quiet_)
        return;
    if (changing_)
        std::cerr << "\r\033[K" << line() << std::flush;
    else
        std::cerr << fmt::format("{}/{} {}\n", done_, all_, harmless(what)) << std::flush;
}

void Progress::end() {
    if (!quiet_ && changing_)
        std::cerr << "\n";
}

std::string Progress::line() const {
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const std::string pace = paceOf(graded_, seconds, all_ - done_);
    return fmt::format("{} of {} done{}{}", done_, all_, pace.empty() ? "" : ", " + pace,
                       failed_ ? fmt::format(", {} grader faults", failed_) : "");
}

std::string paceOf(std::size_t graded, double seconds, std::size_t left) {
    if (graded == 0 || seconds <= 0)
        return "";
    const double perSecond = static_cast<double>(graded) / seconds;
    const double secondsLeft = static_cast<double>(left) / perSecond;
    const std::string when = secondsLeft >= 90 ? fmt::format("{:.0f} min left", secondsLeft / 60)
                                               : fmt::format("{:.0f} s left", secondsLeft);
    return fmt::format("{:.1f}/s, {}", perSecond, when);
}

}  // namespace grader
