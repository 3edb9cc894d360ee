#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Where in the subject a fatal signal struck.
///
/// The dying child writes raw numbers; the parent, which never runs student code, turns them into
/// words.
namespace runner {

/// Child: on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT, writes a report of 64-bit numbers to
/// `descriptor`, then dies of the signal: the driver's work (Census.h), then the addresses of the
/// call stack that lie in the object loaded at `base` … `end` (as offsets from `base`, innermost
/// first). Runs on its own stack, so that endless recursion is reported too.
void installCrashHandlers(int descriptor);
inline constexpr std::size_t kLongestReport = 65;  ///< numbers
void setCrashObject(std::uintptr_t base, std::uintptr_t end);

/// Parent: "rotation, rotation.cpp:17", or "the driver's shader compiler, called by" that; empty
/// when nothing is known. Calls addr2line.
std::string describeCrash(const std::string& objectPath, const std::vector<std::uint64_t>& report);

/// Parent: a sentence about a symbol that nothing defines, with what is defined under the same
/// name. Calls nm.
std::string describeMissingSymbol(const std::string& objectPath, const std::string& symbol);

}  // namespace runner
