#pragma once

#include <string>
#include <vector>

namespace grader {

/// One message of the compiler, as the result document has it.
struct Diagnostic {
    std::string file;
    int line = 0;
    int column = 0;
    std::string severity;  ///< "error" or "warning"
    std::string message;
};

/// Reads `file:line:column: error: message` lines (GCC and Clang) and the linker's complaints;
/// everything else, the quoted source and the notes, is left out.
std::vector<Diagnostic> parseDiagnostics(const std::string& compilerOutput);

/// What a first-year student can do about it; empty when nothing is known.
std::string hintFor(const Diagnostic& diagnostic);

}  // namespace grader
