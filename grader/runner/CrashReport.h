#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Where in the subject a fatal signal struck.
///
/// The dying child writes raw addresses; the parent, which never runs student code, turns them
/// into a function and a line.
namespace runner {

/// Child: on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT, writes the addresses of the call stack
/// that lie in the object loaded at `base` … `end` to `descriptor` (as 64-bit offsets from `base`,
/// innermost first), then dies of the signal. Runs on its own stack, so that endless recursion is
/// reported too.
void installCrashHandlers(int descriptor);
void setCrashObject(std::uintptr_t base, std::uintptr_t end);

/// Parent: "rotation, rotation.cpp:17" for the innermost frame that lies in a file of the stage
/// other than the harness; empty when nothing is known. Calls addr2line.
std::string locateCrash(const std::string& objectPath, const std::vector<std::uint64_t>& offsets);

/// Parent: a sentence about a symbol that nothing defines, with what is defined under the same
/// name. Calls nm.
std::string describeMissingSymbol(const std::string& objectPath, const std::string& symbol);

}  // namespace runner
