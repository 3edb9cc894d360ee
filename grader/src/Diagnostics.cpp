#include "Diagnostics.h"

#include <regex>
#include <sstream>

namespace grader {

namespace {

/// Plain quotes, and without GLM's full template names, which are no help to a reader.
std::string simplified(std::string message) {
    for (const char* quote : {"\u2018", "\u2019"})
        for (auto at = message.find(quote); at != std::string::npos; at = message.find(quote))
            message.replace(at, 3, "'");
    static const std::regex aka(R"( \{aka '[^']*'\})");
    static const std::regex vectorType(
        R"(glm::(vec|mat)<([234])(?:, ([234]))?, float(?:, glm::packed_highp)?>)");
    message = std::regex_replace(message, aka, "");
    return std::regex_replace(message, vectorType, "glm::$1$2");
}

std::string withoutDot(const std::string& file) {
    return file.starts_with("./") ? file.substr(2) : file;
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
         "the harness uses the members of the lecture notes: keep their names, add your own freely"},
        {std::regex(R"(no declaration matches|does not match any)"),
         "name and parameter types must be those of the header, to the letter"},
        {std::regex(R"(multiple definition of)"),
         "two of the submitted files define the same function: keep one of them"},
        {std::regex(R"(expected ';')"), "a semicolon is missing, often at the end of the line before"},
        {std::regex(R"(was not declared in this scope|has not been declared)"),
         "check the spelling, a missing #include, or a missing glm:: in front"},
        {std::regex(R"(expected '\}' at end of input)"), "a closing brace } is missing"},
    };
    return all;
}

}  // namespace

std::vector<Diagnostic> parseDiagnostics(const std::string& compilerOutput) {
    static const std::regex located(
        R"(^([^\s:][^:]*):(\d+):(?:(\d+):)? (?:fatal )?(error|warning): (.*)$)");
    static const std::regex linker(R"(^(?:.*ld[^:]*|mold|.*\.o[^:]*): (?:error: |.*: )?((?:multiple definition of|duplicate symbol).*)$)");
    std::vector<Diagnostic> all;
    std::istringstream lines(compilerOutput);
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (line.size() > 4000)
            continue;  // the regular expressions recurse
        if (std::regex_match(line, match, located))
            all.push_back({withoutDot(match[1]), std::stoi(match[2]),
                           match[3].matched ? std::stoi(match[3]) : 0, match[4],
                           simplified(match[5])});
        else if (std::regex_match(line, match, linker))
            all.push_back({"", 0, 0, "error",
                           std::regex_replace(simplified(match[1]),
                                              std::regex("duplicate symbol:?"),
                                              "multiple definition of")});
    }
    return all;
}

std::string hintFor(const Diagnostic& diagnostic) {
    for (const Hint& hint : hints())
        if (std::regex_search(diagnostic.message, hint.pattern))
            return hint.text;
    return "";
}

}  // namespace grader
