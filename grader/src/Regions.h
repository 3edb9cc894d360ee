#pragma once

#include <map>
#include <optional>
#include <string>

namespace grader {

/// TODO regions of a student's file: the text between the lines
/// `// BEGIN TODO(id)` and `// END TODO(id)`, in C++ and in GLSL.
///
/// A submission need not have any. Returns id → text inside; an unclosed or doubled region is
/// left out, and so is one inside another.
std::map<std::string, std::string> regionsOf(const std::string& text);

/// `text` with the inside of region `id` replaced; nothing when it has no such region.
std::optional<std::string> withRegion(const std::string& text, const std::string& id,
                                      const std::string& body);

/// Number of the line, from 1, on which region `id` begins; 0 when the text has none.
int lineOfRegion(const std::string& text, const std::string& id);

/// `text` with the inside of every region taken out.
std::string outsideRegions(const std::string& text);

}  // namespace grader
