// Loaded before the C library: the clock of the day jumps hours ahead and back at every look.

#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

namespace {

constexpr time_t kJump = 5 * 3600;

time_t jump() {
    static std::atomic<unsigned> looks = 0;
    return ++looks % 2 ? kJump : -kJump;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) {
    const long failed = syscall(SYS_clock_gettime, clock, now);
    if (!failed && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE))
        now->tv_sec += jump();
    return static_cast<int>(failed);
}

int gettimeofday(timeval* now, void*) {
    timespec precise{};
    const int failed = clock_gettime(CLOCK_REALTIME, &precise);
    *now = {precise.tv_sec, precise.tv_nsec / 1000};
    return failed;
}

time_t time(time_t* result) {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    if (result)
        *result = now.tv_sec;
    return now.tv_sec;
}
}
