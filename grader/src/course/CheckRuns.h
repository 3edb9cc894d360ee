#pragma once

#include "Grade.h"
#include "course/DriverComparison.h"
#include "course/Findings.h"
#include "course/MistakeTable.h"

namespace grader {

/// `drivers` below: compares each program's frames with another driver's; null when nobody asked.

/// The starter compiles without a warning and is not_implemented everywhere; the solution earns
/// everything, and so does every variant: another right program, in
/// solutions/NN-name/variants/NAME/, laid over the solution (or, with a loses.json, one that loses
/// in exactly those tasks).
void checkPrograms(const Grader& grader, const Manifest& manifest, Findings& findings,
                   DriverComparison* drivers);

/// The solution with one task's region as the starter has it loses exactly that task.
void checkBlankRegions(const Grader& grader, const Manifest& manifest, Findings& findings);

/// Each mistake loses what its entry says and nothing else, each check is failed by some mistake,
/// and a mistake that `earns_nothing` (identity, zero, a constant) earns nothing in its own task.
/// Returns what each of them lost, and their signatures in `signatures`.
MistakeTable checkMistakes(const Grader& grader, const Manifest& manifest, Findings& findings,
                           Signatures& signatures, DriverComparison* drivers);

}  // namespace grader
