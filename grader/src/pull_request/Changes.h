#pragma once

#include <string>
#include <vector>

#include "Files.h"
#include "Manifest.h"

namespace grader {

/// A pull request: two commits of one repository, which has both.
struct PullRequest {
    fs::path repository;  ///< a checkout or a bare repository
    std::string base;     ///< the commit whose grader grades
    std::string head;     ///< the commit that a student wants merged; it is never checked out
};

/// What a pull request changes, counted from where its branch left the base's.
struct Changes {
    /// Those with a changed file of a student in their folder, and those that inherit one in which
    /// the region of a task of theirs has changed; in order.
    std::vector<std::string> assignments;
    std::vector<std::string> unused;   ///< all other changed paths
    bool unusedCut = false;            ///< there are more than can be listed
    std::vector<std::string> notices;  ///< files of students, renamed or deleted: one sentence each
    /// New files that are called like a student's and lie elsewhere, where that one has not
    /// changed: one sentence each. What they were meant for is not graded.
    std::vector<std::string> misplaced;
};

/// Throws Error where a commit is not in the repository, or is no full name of one (40 or 64
/// hexadecimal digits).
Changes changesOf(const PullRequest& request, const std::vector<Manifest>& course);

/// Writes what students hand in or carry (`submit`, `inherits`) of all assignments, as they are at
/// the head, into one folder for each assignment below `folder`. Anything but a regular file of at
/// most kLargestFile bytes is left out and named: one sentence each is returned.
std::vector<std::string> takeFiles(const PullRequest& request, const std::vector<Manifest>& course,
                                   const fs::path& folder);

/// assignments/NN-name/FILE: where a student's file is in the repository.
std::string pathOf(const std::string& assignment, const std::string& file);

}  // namespace grader
