#include "Includes.h"

#include <regex>
#include <sstream>

namespace grader {

bool includesOnlyHeaders(const std::string& text) {
    if (text.find("\\\n") != std::string::npos || text.find("%:") != std::string::npos ||
        text.find("??") != std::string::npos || text.find("incbin") != std::string::npos ||
        text.find("__has_include") != std::string::npos)
        return false;
    static const std::regex plain(R"re(#[ \t]*include[ \t]*(<[^>]*>|"[^"]*\.(h|hpp|inl)").*)re");
    constexpr std::size_t kLongestDirective = 1000;  // the regular expression recurses
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const auto hash = line.find('#');
        const bool directive =
            hash != std::string::npos && (line.find("include", hash) != std::string::npos ||
                                          line.find("import", hash) != std::string::npos);
        if (directive &&
            (line.size() > kLongestDirective || !std::regex_match(line.substr(hash), plain)))
            return false;
    }
    return true;
}

}  // namespace grader
