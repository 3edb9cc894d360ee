#pragma once

#include "Collect.h"
#include "watch/Changes.h"
#include "watch/FileWatch.h"

namespace grader {

/// An assignment that is watched, and where it stands.
struct Watched {
    Manifest manifest;
    std::vector<fs::path> own, files;  ///< own: those that it submits; files: all that count
    Contents graded;                   ///< what the last grading began with
    Json result;                       ///< the last; null before the first
    std::string report;                ///< the same as a terminal shows it
    Baseline baseline;
    bool due = true;
    bool saved = false;   ///< a file of its own, since the last grading began
    bool faulty = false;  ///< the last grading failed by the grader's own fault
    bool warm = false;    ///< references and signatures are in memory

    /// Everything earned that a program can give points for.
    bool isFull() const;
    /// Whether a file of its own has changed since the last grading began.
    bool ownChanged(const Contents& now) const;
};

/// The assignments of a submission, none of them graded. Watched are the files that each submits,
/// and those that it inherits, in all places of the submission where they are looked for.
std::vector<Watched> watchedOf(const fs::path& root, const Submission& submission,
                               const std::vector<std::string>& assignments);

/// The files of all.
std::vector<fs::path> filesOf(const std::vector<Watched>& all);

}  // namespace grader
