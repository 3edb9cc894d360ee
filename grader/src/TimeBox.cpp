#include "TimeBox.h"

#include <algorithm>

#include "Error.h"

namespace grader {

namespace {

thread_local TimeBox::Clock::time_point endOfThisThread = TimeBox::Clock::time_point::max();

}  // namespace

TimeBox::TimeBox(double seconds)
    : TimeBox(Clock::now() +
              std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {
}

TimeBox::TimeBox(Clock::time_point end) : before_(endOfThisThread) {
    endOfThisThread = std::min(before_, end);
}

TimeBox::~TimeBox() {
    endOfThisThread = before_;
}

TimeBox::Clock::time_point TimeBox::end() {
    return endOfThisThread;
}

void TimeBox::check() {
    if (isOver())
        giveUp();
}

void TimeBox::giveUp() {
    throw Error("it took longer than it may take as a whole, and was ended");
}

}  // namespace grader
