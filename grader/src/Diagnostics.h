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
    std::string source;  ///< the line of the file, see sourceLine; empty where it is not known
};

/// Reads `file:line:column: error: message` lines (GCC and Clang) and what a linker says about a
/// function that is defined twice; everything else, the quoted source and the notes, is left out.
/// Folders of the build do not appear: the same mistake gives the same text in every run.
std::vector<Diagnostic> parseDiagnostics(const std::string& compilerOutput);

/// Keeps the first of those that say the same of one place: a header is compiled with each file
/// that includes it.
void dropRepeated(std::vector<Diagnostic>& diagnostics);

/// A message of a tool without the folders of the paths in it: "/usr/bin/ld: …" is "ld: …".
std::string withoutFolders(const std::string& message);

/// Line `number` (from 1) of a file's text, with tabs as spaces up to every eighth column, as the
/// compiler counts its columns. Empty when there is no such line or it is longer than 400 bytes.
std::string sourceLine(const std::string& text, int number);

/// "Camera.cpp:17:5: ", as much of it as is known; empty when not even the file is.
std::string placeOf(const Diagnostic& diagnostic);

/// What a first-year student can do about it; empty when nothing is known.
std::string hintFor(const Diagnostic& diagnostic);

}  // namespace grader
