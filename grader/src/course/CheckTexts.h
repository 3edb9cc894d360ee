#pragma once

#include "Manifest.h"
#include "Toolchain.h"
#include "course/Findings.h"

namespace grader {

/// What can be told without building anything: text outside the TODO regions is the same in starter
/// and solution, each task has one region and one heading with its points, no file is there that
/// nobody expects.
void checkTexts(const Toolchain& tools, const Manifest& manifest, Findings& findings);

/// Over all assignments: each region belongs to one task, each task id is used once.
void checkIds(const Toolchain& tools, Findings& findings);

}  // namespace grader
