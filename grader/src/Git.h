#pragma once

#include <string>
#include <vector>

#include "Files.h"
#include "Process.h"

namespace grader {

/// Runs git on the repository of `folder`, without pager or questions. What it complains about is
/// in `errors`; `output` holds nothing but what it was asked for. At the limit of output, 4 GiB of
/// memory or a minute it is ended.
ProcessResult git(const fs::path& folder, const std::vector<std::string>& arguments,
                  std::size_t outputLimit = 16u << 20);

/// The parts of git's output that zero bytes end (option -z).
std::vector<std::string> zeroEnded(const std::string& output);

}  // namespace grader
