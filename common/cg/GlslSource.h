#pragma once

#include <string>

namespace cg {

/// What a GLSL source says, read without a compiler. Comments and spacing make no difference;
/// macros and #if are not followed.

/// Whether nothing stands before the directive #version.
bool beginsWithVersion(const std::string& source);

/// The source with `text` as lines of their own behind the line of #version (at its beginning when
/// there is none). The author's lines keep their numbers.
std::string insertAfterVersion(const std::string& source, const std::string& text);

/// Type of the `in` variable of that name, float to vec4; empty when there is none.
std::string typeOfInput(const std::string& source, const std::string& name);

/// Whether the source holds the body of a function of that name.
bool definesFunction(const std::string& source, const std::string& name);

}  // namespace cg
