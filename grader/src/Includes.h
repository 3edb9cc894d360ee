#pragma once

#include <set>
#include <string>

namespace grader {

/// Whether every file that this text can bring in is a header, as far as can be told without a
/// preprocessor: no other name is included, and none is made up or hidden.
bool includesOnlyHeaders(const std::string& text);

/// What it includes, by the last part of the name: "Camera.h". Of a text for which
/// includesOnlyHeaders() holds these are all.
std::set<std::string> includedNames(const std::string& text);

/// The text without the `//` comments that no compiler can take for anything else, line for line:
/// two texts of which this is the same compile to the same object and the same warnings. Where
/// that is not certain at a glance (a quotation mark before it, a block comment or a raw string
/// anywhere, a word that silences a warning), a comment stays.
std::string withoutComments(const std::string& text);

}  // namespace grader
