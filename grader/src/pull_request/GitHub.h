#pragma once

#include <string>
#include <vector>

#include "Result.h"
#include "pull_request/Changes.h"

namespace grader {

/// What a graded pull request came to.
struct PullRequestResult {
    Changes changes;
    std::vector<AssignmentResult> results;  ///< of the changed assignments
    double passFrom = 0;                    ///< percent of an assignment's points

    /// Every changed assignment reached `passFrom`, and no file lies where it is not graded; with
    /// none changed there is nothing to miss.
    bool passed() const;
    bool graderFailed() const;
};

/// The step summary, in GitHub's Markdown, far below the megabyte that GitHub takes: the score of
/// each task with its sentences, the first compile error, and what of the pull request was not
/// used.
std::string summaryOf(const PullRequestResult& graded);
/// The same where there is no result, by a fault of the grader's or of how it was called.
std::string summaryOfFault();

/// Annotations, a workflow command a line: compile errors at the student's lines, of a shader the
/// first, and what each task lost at its TODO region. At most ten errors, ten warnings and ten
/// notices: GitHub shows no more of one step. `files` holds a folder for each assignment with the
/// files that were graded.
std::string annotationsOf(const PullRequestResult& graded, const fs::path& files);

}  // namespace grader
