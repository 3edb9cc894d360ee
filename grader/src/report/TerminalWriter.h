#pragma once

#include <sstream>
#include <string>

#include "Diagnostics.h"

namespace grader {

struct TerminalStyle {
    bool colours = false;
    int width = 80;
    bool pictures = false;  ///< below each lost frame, in 24-bit colour
};

inline constexpr const char* kBold = "\033[1m";
inline constexpr const char* kGreen = "\033[32m";
inline constexpr const char* kRed = "\033[31m";

/// Rows and paragraphs for a terminal, no wider than the style says, made harmless to show. A
/// colour is an escape sequence, "" for none; it is left out where the style has no colours.
class TerminalWriter {
public:
    explicit TerminalWriter(const TerminalStyle& style) : style_(style) {}

    /// Left text, cut where it must be, then right text at the margin.
    void row(const std::string& left, const std::string& right, const char* colour = "");

    /// `lead` once, then words wrapped and indented below each other.
    void paragraph(const std::string& lead, const std::string& text, const char* colour = "");

    /// A message of the compiler with the line that it is about and what can be done about it.
    void diagnostic(const Diagnostic& diagnostic);

    /// Text of our own making, as it is.
    void lines(const std::string& text) { out_ << text; }

    std::string take() { return out_.str(); }

private:
    std::string painted(const std::string& text, const char* colour) const;

    TerminalStyle style_;
    std::ostringstream out_;
};

}  // namespace grader
