#include "subject/EndAllIn.h"

#include <signal.h>
#include <unistd.h>

#include <fstream>

namespace judge {

namespace {

bool isPopulated(const std::string& cgroup) {
    std::ifstream events(cgroup + "/cgroup.events");
    std::string name;
    for (int value = 0; events >> name >> value;)
        if (name == "populated")
            return value != 0;
    return false;
}

}  // namespace

void endAllIn(const std::string& cgroup) {
    constexpr int kMostMilliseconds = 2000;
    for (int i = 0; i < kMostMilliseconds && isPopulated(cgroup); ++i) {
        std::ofstream all(cgroup + "/cgroup.kill");
        if (!(all << 1 << std::flush)) {  // before Linux 5.14
            std::ifstream processes(cgroup + "/cgroup.procs");
            for (pid_t each = 0; processes >> each;)
                if (each > 1)
                    kill(each, SIGKILL);
        }
        usleep(1000);
    }
}

}  // namespace judge
