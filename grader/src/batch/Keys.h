#pragma once

#include <string>
#include <vector>

#include "Grade.h"
#include "batch/Intake.h"

namespace grader {

/// What a recorded result is known again by. Two results with the same `deciding` can differ in
/// titles, hints and points only, which can be counted anew (Remark.h); those with the same
/// `wording`, too, do not differ.
struct Key {
    std::string deciding, wording;
    bool operator==(const Key&) const = default;
};

/// Hashes of what is the same for all submissions of a batch. Of the assignment only what a subject
/// is built from, what checks it and what it is compared with decides: neither the handout nor the
/// window does, nor another assignment in which nothing is inherited. Draws nothing, but asks what
/// would draw.
Key keyOfRules(const Grader& grader, const Sandbox& sandbox, const Manifest& manifest,
               std::uint64_t seed);

/// A submission under those rules. What of it cannot be read counts as such.
Key keyOf(const Key& rules, const fs::path& root, const Manifest& manifest, const Entrant& entrant,
          const std::vector<std::string>& known);

}  // namespace grader
