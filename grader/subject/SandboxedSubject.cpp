#include "subject/JudgeMain.h"

namespace judge {

std::unique_ptr<Subject> makeSubject(const std::vector<std::string>& runnerCommand) {
    return startSubject(runnerCommand);
}

}  // namespace judge
