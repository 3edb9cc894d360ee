#pragma once

#include <string>

#include "Result.h"

namespace grader {

/// Pieces that the parts of the page share. Whatever takes text escapes it; whatever returns is
/// HTML.

/// Text as HTML shows it, in an element or in quotes, without what steers (harmless); lines stay.
std::string escaped(const std::string& text);

/// Bytes in base 64.
std::string base64(const std::string& bytes);

/// A status as its sign, in the status's colour, with its name for those who do not see it.
std::string markOf(Status status);

/// A bar that is filled by the share of the points.
std::string barOf(double points, double most);

/// An <img> that holds the file itself.
std::string pictureOf(const fs::path& file, const std::string& className, const std::string& alt);

}  // namespace grader
