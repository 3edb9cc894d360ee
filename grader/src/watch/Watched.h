#pragma once

#include "Collect.h"
#include "watch/Changes.h"
#include "watch/FileWatch.h"

namespace grader {

/// An assignment that is watched, and where it stands.
struct Watched {
    Manifest manifest;
    std::vector<std::string> names;  ///< of the files that students hand in for it
    std::vector<fs::path> own;       ///< where those may be that it submits
    std::vector<fs::path> shared;    ///< those of an earlier one, in which a task of it is solved
    std::vector<fs::path> files;     ///< all that count
    Contents graded;                 ///< what the last grading began with
    Json result;                     ///< the last; null before the first
    std::string report;              ///< the same as a terminal shows it
    Baseline baseline;
    bool due = true;
    bool saved = false;   ///< a file that is handed in for it, since the last grading began
    bool faulty = false;  ///< the last grading failed by the grader's own fault
    bool warm = false;    ///< references and signatures are in memory

    /// Everything earned that a program can give points for.
    bool isFull() const;
    /// Whether it has been graded, and a task of it was more than a blank region.
    bool isBegun() const;
    /// Whether one of these files has changed since the last grading began.
    bool changed(const std::vector<fs::path>& some, const Contents& now) const;
};

/// The assignments of a submission, none of them graded. Watched are the files that each submits,
/// and those that it inherits, in all places of the submission where they are looked for.
std::vector<Watched> watchedOf(const fs::path& root, const Submission& submission,
                               const std::vector<std::string>& assignments);

/// The files of all.
std::vector<fs::path> filesOf(const std::vector<Watched>& all);

/// FILE:LINE where the region of a task begins in the submission; empty where no file has one.
std::string placeOfRegion(const Submission& submission, const Manifest& manifest,
                          const std::string& task);

}  // namespace grader
