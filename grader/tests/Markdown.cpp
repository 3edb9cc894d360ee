#include "Markdown.h"

#include <cctype>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

namespace lab {

namespace {

const std::set<std::string> kShells = {"", "sh", "bash", "console"};

struct Line {
    std::string text;
    int number = 0;
    int block = 0;         ///< 0 outside of fenced blocks
    std::string language;  ///< of the block
};

/// Every line but the fences themselves.
std::vector<Line> linesOf(const std::string& markdown) {
    static const std::regex fence(R"(\s*```\s*(\S*)\s*)");
    std::vector<Line> lines;
    std::istringstream in(markdown);
    std::string text, language;
    int blocks = 0;
    bool inside = false;
    for (int number = 1; std::getline(in, text); ++number) {
        if (std::smatch match; std::regex_match(text, match, fence)) {
            inside = !inside;
            language = match[1];
            blocks += inside ? 1 : 0;
        } else {
            lines.push_back({text, number, inside ? blocks : 0, language});
        }
    }
    return lines;
}

std::string trimmed(const std::string& text) {
    const auto from = text.find_first_not_of(" \t");
    return from == std::string::npos ? ""
                                     : text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

std::string withoutComment(const std::string& line) {
    return std::regex_replace(line, std::regex("(^|\\s)#.*"), "");
}

/// Calls `take` with the parts between "&&".
void forEachStep(const std::string& line, const std::function<void(const std::string&)>& take) {
    std::size_t from = 0;
    for (auto at = line.find("&&"); from != std::string::npos; at = line.find("&&", from)) {
        if (const std::string step = trimmed(line.substr(from, at - from)); !step.empty())
            take(step);
        from = at == std::string::npos ? at : at + 2;
    }
}

}  // namespace

std::vector<Command> commandsIn(const std::string& markdown) {
    static const std::regex code("`([^`]+)`"),
        ours(R"(\./(grade|test)( .*)?|(ctest|cmake|ninja|docker) .*)");
    std::vector<Command> commands;
    std::string begun;  // of a line that goes on
    int begunAt = 0;
    for (const Line& line : linesOf(markdown)) {
        if (line.block && kShells.contains(line.language)) {
            std::string text = begun + trimmed(withoutComment(line.text));
            const int at = begun.empty() ? line.number : begunAt;
            begun.clear();
            if (text.ends_with('\\')) {
                text.pop_back();
                begun = text;
                begunAt = at;
                continue;
            }
            forEachStep(text, [&](const std::string& step) {
                commands.push_back({step, at, false, line.block});
            });
        } else if (!line.block) {
            for (std::sregex_iterator it(line.text.begin(), line.text.end(), code), end; it != end;
                 ++it)
                if (const std::string text = (*it)[1]; std::regex_match(text, ours))
                    commands.push_back({text, line.number, true, 0});
        }
    }
    return commands;
}

std::vector<Link> linksIn(const std::string& markdown) {
    static const std::regex code("`[^`]*`"), link(R"(\]\(([^)\s]+)\))");
    std::vector<Link> links;
    for (const Line& line : linesOf(markdown)) {
        if (line.block)
            continue;
        const std::string text = std::regex_replace(line.text, code, "`");
        for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it)
            if (const std::string target = (*it)[1]; target.find("://") == std::string::npos)
                links.push_back({target, line.number});
    }
    return links;
}

std::vector<std::string> anchorsOf(const std::string& markdown) {
    std::vector<std::string> anchors;
    for (const Line& line : linesOf(markdown)) {
        if (line.block || !line.text.starts_with('#'))
            continue;
        std::string anchor;
        for (const char c : trimmed(line.text.substr(line.text.find_first_not_of('#'))))
            if (c == ' ')
                anchor += '-';
            else if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c < 0)
                anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        anchors.push_back(anchor);
    }
    return anchors;
}

}  // namespace lab
