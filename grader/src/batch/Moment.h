#pragma once

#include <chrono>
#include <string>

namespace grader {

using Moment = std::chrono::sys_seconds;

/// Reads "2026-11-03T23:59:00+01:00", "2026-11-03 23:59 Z", "2026-11-03 22:59:00.123 UTC". A time
/// must say its distance from UTC, or a deadline would depend on the machine. Throws Error that
/// begins with `where`.
Moment parseMoment(const std::string& text, const std::string& where);

/// "2026-11-03T22:59:00Z"
std::string toString(Moment moment);

}  // namespace grader
