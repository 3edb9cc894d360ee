#pragma once

#include "Files.h"
#include "Process.h"

namespace lab {

/// A checkout of a test's own: every file of this one but what git keeps out, and the grader of
/// this build as its own, so that what a test changes changes nothing here. ./grade in it starts
/// the grader at once; judges and kit are those of this build.
class CourseCopy {
public:
    CourseCopy();

    const grader::fs::path& root() const { return work_.path(); }
    grader::fs::path build() const { return root() / "build/release"; }

    /// A line of a shell, run in `folder` below the top.
    grader::ProcessResult sh(const std::string& line, const std::string& folder = ".",
                             double seconds = 120) const;

    /// The assignments' programs (NN-name, NN-name_tests, …), built by the CMake files of the copy
    /// with the libraries of this build; see one_assignment.cmake. Returns what was printed.
    grader::ProcessResult buildAssignment(const std::string& targets) const;

private:
    grader::WorkFolder work_;
};

}  // namespace lab
