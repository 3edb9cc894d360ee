#pragma once

#include <string>

#include "compare/Picture.h"

namespace grader {

/// Two pictures beside each other, in half-block characters with 24-bit colour: one character is
/// two pixels, one above the other. Each picture is `columns` wide and both have the reference's
/// shape; a smaller pixel is the mean of those that it stands for. The first line names them; every
/// line begins with `indent` spaces and ends with the terminal's own colours.
std::string previewOf(const Picture& yours, const Picture& reference, int columns, int indent);

/// One sentence on why this terminal cannot show them; empty when it can. `isTerminal`: whether
/// standard output is one. `colorterm`: the environment's COLORTERM, null where it is not set.
std::string whyNoPreviews(bool isTerminal, const char* colorterm);

}  // namespace grader
