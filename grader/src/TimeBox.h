#pragma once

#include <chrono>
#include <future>

namespace grader {

/// How long something may take as a whole, whatever its parts may take.
///
/// While one lives, whatever its thread does is within its time, and so is what that starts with
/// alongside(). When the time is over, run() kills its command and throws Error, as check() does.
/// Of two boxes the inner one can only be shorter. Kept by the monotonic clock, which nobody sets.
class TimeBox {
public:
    using Clock = std::chrono::steady_clock;

    explicit TimeBox(double seconds);
    /// The box of another thread, which began it.
    explicit TimeBox(Clock::time_point end);
    ~TimeBox();
    TimeBox(const TimeBox&) = delete;
    TimeBox& operator=(const TimeBox&) = delete;

    /// When the time of this thread is over; never without a box.
    static Clock::time_point end();
    static bool isOver() { return Clock::now() >= end(); }
    /// Throws Error when it is over.
    static void check();
    /// Throws it at once.
    [[noreturn]] static void giveUp();

private:
    Clock::time_point before_;
};

/// std::async, for a part of what this thread does: within the same time.
template <class Work>
auto alongside(Work work) {
    return std::async(std::launch::async, [work = std::move(work), end = TimeBox::end()]() mutable {
        const TimeBox box(end);
        return work();
    });
}

}  // namespace grader
