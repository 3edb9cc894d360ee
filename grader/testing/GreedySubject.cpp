// A subject whose functions take more than they may have, or long: what Child_test.cpp and
// Cgroup_test.cpp run.

#include <fcntl.h>
#include <unistd.h>

#include <cstring>

#include "runner/Harness.h"

CG_HARNESS(harness) {
    harness.function("modest", [](int value) { return value + 1; });
    harness.function("spin", [](int value) {
        volatile int turns = value;
        while (turns >= 0)
            turns = turns ^ 1;
        return 0;
    });
    harness.function("eat", [](int value) {
        for (;;)
            std::memset(new char[1 << 20], value, 1 << 20);
        return 0;
    });
    // No signal interrupts who waits for a child of vfork, and none who waits for a disk.
    harness.function("wait", [](int seconds) {
        if (vfork() == 0) {
            sleep(static_cast<unsigned>(seconds));
            _exit(0);
        }
        return seconds;
    });
    harness.function("sleep", [](int seconds) {
        sleep(static_cast<unsigned>(seconds));
        return seconds;
    });
    harness.function("hoard", [](int value) {
        while (open("/dev/null", O_RDONLY | O_CLOEXEC) >= 0) {
        }
        return value;
    });
}
