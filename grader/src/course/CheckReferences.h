#pragma once

#include "Grade.h"
#include "course/Findings.h"

namespace grader {

/// References are what the solutions, starters and mistakes draw today, and a picture that shows
/// nothing learnt (the starter's, black, one colour) earns nothing in any frame or feature.
void checkReferences(const Grader& grader, const Manifest& manifest, Findings& findings);

/// Stored signatures are those of today's mistakes.
void checkSignatures(const Grader& grader, const Manifest& manifest, const Signatures& today,
                     Findings& findings);

}  // namespace grader
