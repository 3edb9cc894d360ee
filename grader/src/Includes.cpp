#include "Includes.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <sstream>

namespace grader {

namespace {

/// The regular expression recurses.
constexpr std::size_t kLongestDirective = 1000;

/// A line may go on in the next, or a character be written in another way.
bool hasHiddenLines(const std::string& text) {
    if (text.find("??") != std::string::npos || text.find("%:") != std::string::npos)
        return true;
    for (auto at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1))
        if (at + 1 == text.size() || std::isspace(static_cast<unsigned char>(text[at + 1])))
            return true;
    return false;
}

/// The directive in a line that can bring in a file; empty for every other line.
std::string directiveIn(const std::string& line) {
    const auto hash = line.find('#');
    const bool includes =
        hash != std::string::npos && (line.find("include", hash) != std::string::npos ||
                                      line.find("import", hash) != std::string::npos);
    return includes ? line.substr(hash) : "";
}

/// The name in an #include of a header; empty for any other directive.
std::string headerIn(const std::string& directive) {
    static const std::regex plain(
        R"re(#[ \t]*include[ \t]*(?:<([^>]*)>|"([^"]*\.(?:h|hpp|inl))").*)re");
    std::smatch found;
    if (directive.size() > kLongestDirective || !std::regex_match(directive, found, plain))
        return "";
    return found[1].matched ? found[1].str() : found[2].str();
}

/// A comment that says nothing to a compiler: "falls through" silences a warning, characters that
/// change the direction of writing cause one.
bool isSilent(const std::string& comment) {
    static const std::string word = "fall";
    return std::all_of(comment.begin(), comment.end(),
                       [](char each) { return each == '\t' || (each >= ' ' && each <= '~'); }) &&
           std::search(comment.begin(), comment.end(), word.begin(), word.end(),
                       [](char a, char b) {
                           return std::tolower(static_cast<unsigned char>(a)) == b;
                       }) == comment.end();
}

std::string withoutComment(const std::string& line) {
    const auto comment = line.find("//");
    if (comment == std::string::npos || line.find_first_of("\"'#") < comment ||
        !isSilent(line.substr(comment)))
        return line;
    const std::string code = line.substr(0, comment);
    return code.substr(0, code.find_last_not_of(" \t") + 1);
}

}  // namespace

bool includesOnlyHeaders(const std::string& text) {
    if (hasHiddenLines(text) || text.find("incbin") != std::string::npos ||
        text.find("__has_include") != std::string::npos)
        return false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (const std::string directive = directiveIn(line);
            !directive.empty() && headerIn(directive).empty())
            return false;
    return true;
}

std::set<std::string> includedNames(const std::string& text) {
    std::set<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (const std::string name = headerIn(directiveIn(line)); !name.empty())
            names.insert(std::filesystem::path(name).filename().string());
    return names;
}

std::string withoutComments(const std::string& text) {
    // So that every line begins outside of everything.
    if (hasHiddenLines(text) || text.find("/*") != std::string::npos ||
        text.find("R\"") != std::string::npos)
        return text;
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);)
        result += withoutComment(line) + "\n";
    return result;
}

}  // namespace grader
