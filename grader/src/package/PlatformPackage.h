#pragma once

#include <cstdint>

#include "Manifest.h"
#include "package/CourseFiles.h"

namespace grader {

/// What a learning platform needs to grade one assignment on machines of its own; see
/// docs/platforms.md. Each is made of `course`, the committed files that grading uses, and of the
/// platform's scripts in grader/platforms/. Throws Error where one of those is missing.
struct PackageOrder {
    const CourseFiles& course;
    const Manifest& manifest;
    std::uint64_t seed = 1;
};

/// The files of autograder.zip: setup.sh, run_autograder, not-graded.json, course/.
CourseFiles gradescopePackage(const PackageOrder& order);

/// README.md, tests/ for the question's folder, and image/ to build the public image from, which
/// has no solution and no hidden test. What drawing references and mending prerequisites needs of
/// the solutions is in tests/, which PrairieLearn keeps from students.
CourseFiles prairieLearnPackage(const PackageOrder& order);

/// README.md, autograde-Makefile, autograde.tar, and image/ to build the private image from.
CourseFiles autolabPackage(const PackageOrder& order);

}  // namespace grader
