#include "subject/JudgeMain.h"

namespace judge {

std::unique_ptr<Subject> makeSubject(const std::vector<std::string>& runnerCommand,
                                     const KernelLimits& limits) {
    return startSubject(runnerCommand, limits);
}

}  // namespace judge
