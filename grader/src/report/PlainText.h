#pragma once

#include <string>

namespace grader {

/// Text that may come from a student, made safe to show: what is not UTF-8 becomes '?', and each
/// character that steers instead of showing becomes a space: control characters, in UTF-8 the
/// second set too, and those that turn the direction of writing. Line ends stay where `keepLines`.
std::string harmless(std::string text, bool keepLines = false);

/// With small letters (of ASCII).
std::string lowered(std::string text);

/// Columns that a text of UTF-8 takes; every sign of ours takes one.
std::size_t columns(const std::string& text);

/// Bytes of the first `most` columns.
std::size_t bytesOf(const std::string& text, std::size_t most);

/// The text in at most so many columns; "…" stands for the rest.
std::string shortened(const std::string& text, std::size_t most);

}  // namespace grader
