#include "Diagnostics.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <tuple>

namespace grader {

namespace {

constexpr std::size_t kLongestLine = 2000;  // regular expressions recurse
constexpr std::size_t kLongestSource = 400;
constexpr std::size_t kTabStop = 8;

/// Plain quotes, and without GLM's full template names, which are no help to a reader.
std::string simplified(std::string message) {
    for (const char* quote : {"\u2018", "\u2019"})
        for (auto at = message.find(quote); at != std::string::npos; at = message.find(quote))
            message.replace(at, 3, "'");
    static const std::regex aka(R"( \{aka '[^']*'\})");
    static const std::regex vectorType(
        R"(glm::(vec|mat)<([234])(?:, ([234]))?, float(?:, (?:glm::packed_highp|\(glm::qualifier\)0))?>)");
    message = std::regex_replace(message, aka, "");
    return std::regex_replace(message, vectorType, "glm::$1$2");
}

/// A file of the stage by its name there; any other by its last part, since its folder is ours.
std::string nameOf(const std::string& file) {
    if (file.starts_with("/"))
        return file.substr(file.rfind('/') + 1);
    static const std::regex here(R"(^(?:\./+)+)");
    return std::regex_replace(file, here, "");
}

std::optional<Diagnostic> fromCompiler(const std::string& line) {
    static const std::regex located(
        R"(([^\s:][^:]*):(\d{1,9}):(?:(\d{1,9}):)? (?:fatal )?(error|warning): )");
    std::smatch match;
    if (!std::regex_search(line, match, located, std::regex_constants::match_continuous))
        return std::nullopt;
    return Diagnostic{nameOf(match[1]), std::stoi(match[2]),
                      match[3].matched ? std::stoi(match[3]) : 0, match[4],
                      withoutFolders(simplified(match.suffix()))};
}

/// The source file that a linker means by "…/Camera.cpp.o", "…/inherited.a(Camera.cpp.o)" or
/// "./Camera.cpp:17", and the line when it knows one.
Diagnostic sourceIn(const std::string& text) {
    static const std::regex source(
        R"((?:^|/|: )(?:[^/:]*\.a\()?([^/:]+?\.(?:cpp|h|inl))(?:\.o\)?)?(?::(\d{1,9}))?)");
    Diagnostic found;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), source);
         it != std::sregex_iterator(); ++it) {
        found.file = (*it)[1];
        found.line = (*it)[2].matched ? std::stoi((*it)[2]) : 0;
    }
    return found;
}

/// Two definitions of one function, in the words of GNU ld, gold, mold and lld.
std::optional<Diagnostic> fromLinker(const std::string& line) {
    static const std::regex gnu(R"((.*): multiple definition of [`']([^']*)'(?:; (.*))?)");
    static const std::regex mold(R"(mold: error: duplicate symbol: (.+?): (.+?): (.*))");
    static const std::regex lld(R"(ld\.lld: error: duplicate symbol: (.*))");
    std::smatch match;
    std::string symbol, second, first;
    if (std::regex_match(line, match, gnu))
        second = match[1], symbol = match[2], first = match[3];
    else if (std::regex_match(line, match, mold))
        second = match[1], first = match[2], symbol = match[3];
    else if (std::regex_match(line, match, lld))
        symbol = match[1];
    else
        return std::nullopt;
    Diagnostic result = sourceIn(second);
    result.severity = "error";
    result.message = "multiple definition of '" + simplified(symbol) + "'";
    const Diagnostic other = sourceIn(first);
    if (!other.file.empty())
        result.message += ", defined before in " + other.file +
                          (other.line ? ":" + std::to_string(other.line) : "");
    return result;
}

struct Hint {
    std::regex pattern;
    const char* text;
};

const std::vector<Hint>& hints() {
    static const std::vector<Hint> all = {
        {std::regex(R"(no member named .(near|far)\b)"),
         "the members are called near and far, as in code 8.1 of the notes. (On Windows, "
         "windows.h makes macros of both names; `#undef near` and `#undef far` after it.)"},
        {std::regex(R"(has no member named)"),
         "the harness uses the members of the lecture notes: keep their names, add your own "
         "freely"},
        {std::regex(R"(no declaration matches|does not match any)"),
         "name and parameter types must be those of the header, to the letter"},
        {std::regex(R"(multiple definition of)"),
         "two files in the folder define the same function: keep one of them"},
        {std::regex(
             R"(operand types are '(double|int)' and 'glm::|operand types are 'glm::.*' and '(double|int)')"),
         "GLM multiplies its matrices and vectors of float by a float alone: write 2.0f, std::cos "
         "and std::sin of a float, or float(...) around it"},
        {std::regex(R"(expected ('.' or )?';')"),
         "a semicolon is missing, often at the end of the line before"},
        {std::regex(R"(No such file or directory, but there is)"),
         "upper and lower case make two names on Linux, though one on Windows and macOS: write the "
         "name exactly as the file has it"},
        {std::regex(R"('M_PI' was not declared)"),
         "M_PI is no part of standard C++: #include <numbers> and write std::numbers::pi"},
        {std::regex(R"(was not declared in this scope|has not been declared)"),
         "check the spelling, a missing #include, or a missing glm:: in front"},
        {std::regex(R"(no return statement in function|control reaches end of non-void)"),
         "every way through a function that returns something ends in a return; without it, what "
         "the caller gets is chance, or a crash"},
        {std::regex(R"(expected '\}' at end of input)"), "a closing brace } is missing"},
    };
    return all;
}

}  // namespace

std::vector<Diagnostic> parseDiagnostics(const std::string& compilerOutput) {
    std::vector<Diagnostic> all;
    std::istringstream lines(compilerOutput);
    for (std::string line; std::getline(lines, line);) {
        line.resize(std::min(line.size(), kLongestLine));
        if (auto compiler = fromCompiler(line))
            all.push_back(std::move(*compiler));
        else if (auto linker = fromLinker(line))
            all.push_back(std::move(*linker));
    }
    return all;
}

void dropRepeated(std::vector<Diagnostic>& diagnostics) {
    std::set<std::tuple<std::string, int, int, std::string>> said;
    std::erase_if(diagnostics, [&](const Diagnostic& each) {
        return !said.emplace(each.file, each.line, each.column, each.message).second;
    });
}

std::string withoutFolders(const std::string& message) {
    static const std::regex folders(R"((^|[\s'"(:])(?:\.{0,2}/)(?:[\w.+-]{1,255}/)*(?=[\w.+-]))");
    return std::regex_replace(message.substr(0, kLongestLine), folders, "$1");
}

std::string sourceLine(const std::string& text, int number) {
    std::size_t from = 0;
    for (int i = 1; i < number && from != std::string::npos; ++i)
        if (from = text.find('\n', from); from != std::string::npos)
            ++from;
    if (number < 1 || from >= text.size())
        return "";
    const std::string line =
        text.substr(from, std::min(text.find('\n', from), from + kLongestSource + 1) - from);
    if (line.size() > kLongestSource)
        return "";
    std::string expanded;
    std::size_t column = 0;
    for (const char each : line) {
        const std::size_t width = each == '\t' ? kTabStop - column % kTabStop
                                               : (static_cast<unsigned char>(each) & 0xC0) != 0x80;
        expanded += each == '\t' ? std::string(width, ' ') : std::string(1, each);
        column += width;
    }
    return expanded;
}

std::string placeOf(const Diagnostic& diagnostic) {
    std::string place = diagnostic.file;
    for (const int number : {diagnostic.line, diagnostic.line ? diagnostic.column : 0})
        if (number > 0)
            place += ":" + std::to_string(number);
    return place.empty() ? place : place + ": ";
}

std::string hintFor(const Diagnostic& diagnostic) {
    for (const Hint& hint : hints())
        if (std::regex_search(diagnostic.message, hint.pattern))
            return hint.text;
    return "";
}

}  // namespace grader
