#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace grader {

/// How far a batch is, on standard error: one line that changes on a terminal, else a line for each
/// submission.
class Progress {
public:
    Progress(std::size_t all, bool quiet);

    /// After each submission. `fromBefore`: it took no time.
    void count(const std::string& what, bool failed, bool fromBefore);

    /// Ends the line that changes.
    void end();

private:
    std::string line() const;

    const std::size_t all_;
    const bool quiet_, changing_;
    std::size_t done_ = 0, graded_ = 0, failed_ = 0;
    std::chrono::steady_clock::time_point start_;
};

/// "1.4/s, 3 min left" from so many graded in so many seconds; empty before the first.
std::string paceOf(std::size_t graded, double seconds, std::size_t left);

}  // namespace grader
