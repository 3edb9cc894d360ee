#pragma once

#include <string>

#include "Result.h"

namespace grader {

/// What both reports say in the same signs and words.

/// One sign that tells a status without its colour: ✓ ◐ ○ – ! ✗
const char* symbolOf(Status status);

/// A status as people read it: "not implemented".
std::string nameOf(Status status);

/// Points as people read them: at most one decimal.
std::string showPoints(double points);

/// "5.5 / 20"
std::string scoreText(double points, double most);

/// One sentence: what is done, and what to do next.
std::string whatNext(const AssignmentResult& result);

/// The line that a compiler's message is about, and below it a caret where the column is known.
/// At most `width` columns of the line are shown, those around the caret. Empty without a source.
struct QuotedSource {
    std::string line, caret;
};
QuotedSource quoted(const Diagnostic& diagnostic, std::size_t width);

}  // namespace grader
