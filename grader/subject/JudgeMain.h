#pragma once

#include <memory>
#include <string>
#include <vector>

#include "subject/Subject.h"

namespace judge {

/// The subject that a test program talks to: another process, or linked in for the debugger.
std::unique_ptr<Subject> makeSubject(const std::vector<std::string>& runnerCommand,
                                     const KernelLimits& limits);

}  // namespace judge
