#pragma once

#include "Manifest.h"

namespace grader {

/// The files that one assignment hands in and the next one uses: inherits, or hands in, too.
std::vector<std::string> carriedNames(const Manifest& from, const Manifest& to);

/// Copies a student's finished files from assignments/FROM to assignments/TO, where they count from
/// then on. Returns what to tell, whole lines.
///
/// A file that is there already is replaced only when it is still the starter or by force, and then
/// kept as NAME.before-carry. Throws Error, before anything is written, when TO uses nothing of
/// FROM, when FROM has not been begun, when a file is missing, or when one would be overwritten.
std::string carry(const fs::path& root, const std::string& from, const std::string& to, bool force);

}  // namespace grader
