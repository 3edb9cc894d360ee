#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "batch/Standing.h"

namespace grader {

/// Submissions that are graded at the same time, each by a thread, and nobody waits forever.
struct Crew {
    int workers = 1;
    /// How long one submission may take, by the monotonic clock. A thread that has not come back
    /// by then hangs in the grader's own code or in the machine's, for all that it started has
    /// ended long before. No thread can be ended from outside: it is left behind, and another
    /// takes its place.
    double patienceSeconds = 0;

    struct Done {
        std::vector<std::optional<Standing>> standings;  ///< none where it was not begun
        /// A thread that was left behind may still hold on to what the work refers to: the process
        /// must end without taking that apart.
        bool someoneWasLeftBehind = false;
    };

    /// Does the work of 0 … count-1 in this order, none begun once `stop` is true. `lost` says what
    /// becomes of one that was left behind. `tell` is called after each, by one thread at a time.
    Done run(std::size_t count, const std::function<Standing(std::size_t)>& work,
             const std::function<Standing(std::size_t)>& lost, const std::atomic<bool>& stop,
             const std::function<void(const Standing&)>& tell) const;
};

}  // namespace grader
