#include "Git.h"

namespace grader {

namespace {
constexpr double kSeconds = 20;
// A repository may come from a stranger: a small one can unfold without end.
constexpr const char* kLimits[] = {"prlimit", "--as=4294967296", "--cpu=20"};
}  // namespace

ProcessResult git(const fs::path& folder, const std::vector<std::string>& arguments,
                  std::size_t outputLimit) {
    std::vector<std::string> command(std::begin(kLimits), std::end(kLimits));
    command.insert(command.end(),
                   {"env", "GIT_TERMINAL_PROMPT=0", "git", "-C", folder, "--no-pager"});
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run(command, kSeconds,
               {.outputLimit = outputLimit, .endAtLimit = true, .errorsApart = true});
}

std::vector<std::string> zeroEnded(const std::string& output) {
    std::vector<std::string> parts;
    for (std::size_t from = 0, end; (end = output.find('\0', from)) != std::string::npos;
         from = end + 1)
        parts.push_back(output.substr(from, end - from));
    return parts;
}

}  // namespace grader
