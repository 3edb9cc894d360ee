#pragma once

#include <string>

namespace grader {

/// The solution's text with the starter's blanks in its TODO regions. Throws Error, which names
/// `name`, when the two do not have the same regions: then nothing can be carried over without
/// guessing.
std::string syncedStarter(const std::string& name, const std::string& starter,
                          const std::string& solution);

}  // namespace grader
