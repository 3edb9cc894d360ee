#pragma once

#include <string>

namespace judge {

/// Kills all processes in a cgroup and waits, two seconds at most, until they are gone with all
/// that they had: what starts there next must not find it taken. Does nothing where there is no
/// such folder.
void endAllIn(const std::string& cgroup);

}  // namespace judge
