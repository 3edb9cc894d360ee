#include "report/TerminalWriter.h"

#include "report/PlainText.h"
#include "report/Words.h"

namespace grader {

std::string TerminalWriter::painted(const std::string& text, const char* colour) const {
    return style_.colours && *colour ? colour + text + "\033[0m" : text;
}

void TerminalWriter::row(const std::string& left, const std::string& right, const char* colour) {
    const auto width = static_cast<std::size_t>(style_.width) - columns(right);
    const std::string text = shortened(harmless(left), width - 1);
    out_ << painted(text, colour) << std::string(width - columns(text), ' ') << right << "\n";
}

void TerminalWriter::paragraph(const std::string& lead, const std::string& text,
                               const char* colour) {
    const std::size_t indent = columns(lead);
    const auto width = static_cast<std::size_t>(style_.width);
    std::istringstream words(harmless(text));
    std::string line = lead;
    bool empty = true;
    for (std::string word; words >> word;) {
        if (!empty && columns(line) + 1 + columns(word) > width) {
            out_ << painted(line, colour) << "\n";
            line = std::string(indent, ' ');
            empty = true;
        }
        line += (empty ? "" : " ") + word;
        empty = false;
        while (columns(line) > width) {  // one word that is longer than a line
            const std::size_t cut = bytesOf(line, width);
            out_ << painted(line.substr(0, cut), colour) << "\n";
            line = std::string(indent, ' ') + line.substr(cut);
        }
    }
    out_ << painted(line, colour) << "\n";
}

void TerminalWriter::diagnostic(const Diagnostic& diagnostic) {
    const bool error = diagnostic.severity == "error";
    paragraph(error ? "    ✗ " : "    ! ",
              placeOf(diagnostic) + (error ? "" : "warning: ") + diagnostic.message);
    const std::string indent(8, ' ');
    const auto source =
        quoted(diagnostic, static_cast<std::size_t>(style_.width) - indent.size() - 1);
    if (!source.line.empty())
        lines(indent + source.line + "\n");
    if (!source.caret.empty())
        lines(indent + source.caret + "\n");
    if (const std::string hint = hintFor(diagnostic); !hint.empty())
        paragraph("      hint: ", hint);
}

}  // namespace grader
