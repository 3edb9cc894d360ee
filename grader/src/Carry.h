#pragma once

#include "Manifest.h"

namespace grader {

/// Which files of one assignment the next one uses.
struct CarriedNames {
    std::vector<std::string> inherited;  ///< found in the first one's folder when it is graded
    std::vector<std::string> submitted;  ///< handed in for both: the second needs a copy

    bool empty() const { return inherited.empty() && submitted.empty(); }
};
CarriedNames carriedNames(const Manifest& from, const Manifest& to);

struct CarryWish {
    bool copy = false;   ///< inherited files, too
    bool force = false;  ///< over files that differ, which are kept beside under another name
};

/// Carries a student's finished files from assignments/FROM to assignments/TO: copies those that
/// both hand in, and with `copy` those that TO inherits. Returns what to tell, whole lines.
///
/// A file that is there already is replaced only when it is still the starter or by force, and then
/// kept as NAME.before-carry. Throws Error, before anything is written, when TO uses nothing of
/// FROM, when FROM has not been begun, when a file is missing, or when one would be overwritten.
std::string carry(const fs::path& root, const std::string& from, const std::string& to,
                  const CarryWish& wish);

}  // namespace grader
