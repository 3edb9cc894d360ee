#include <cg/GlslSource.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace cg {
namespace {

/// Words and signs, one after the other; each is a part of the source.
using Tokens = std::vector<std::string_view>;

bool isInWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Length of the comment that `text` begins with; 0 when it begins with none.
std::size_t commentLength(std::string_view text) {
    if (text.starts_with("//")) {
        return std::min(text.find_first_of("\r\n"), text.size());
    }
    if (text.starts_with("/*")) {
        const std::size_t end = text.find("*/", 2);
        return end == std::string_view::npos ? text.size() : end + 2;
    }
    return 0;
}

std::size_t tokenLength(std::string_view text) {
    const auto end = std::find_if_not(text.begin(), text.end(), isInWord);
    return std::max<std::size_t>(1, static_cast<std::size_t>(end - text.begin()));
}

// By hand: a regular expression of libstdc++ calls itself once for each character that it repeats
// over, and a long comment overflows the stack.
Tokens tokensOf(std::string_view source) {
    Tokens tokens;
    while (!source.empty()) {
        std::size_t length = commentLength(source);
        if (std::isspace(static_cast<unsigned char>(source[0])) != 0) {
            length = 1;
        } else if (length == 0) {
            length = tokenLength(source);
            tokens.push_back(source.substr(0, length));
        }
        source.remove_prefix(length);
    }
    return tokens;
}

/// The token of that index; empty behind the last one.
std::string_view at(const Tokens& tokens, std::size_t index) {
    return index < tokens.size() ? tokens[index] : std::string_view();
}

bool isWord(std::string_view token) {
    return !token.empty() && isInWord(token[0]);
}

bool isInputType(std::string_view token) {
    return token == "float" || token == "vec2" || token == "vec3" || token == "vec4";
}

/// The `#` of the directive #version; end() when there is none.
Tokens::const_iterator findVersion(const Tokens& tokens) {
    static constexpr std::string_view directive[] = {"#", "version"};
    return std::search(tokens.begin(), tokens.end(), std::begin(directive), std::end(directive));
}

}  // namespace

bool beginsWithVersion(const std::string& source) {
    const Tokens tokens = tokensOf(source);
    return !tokens.empty() && findVersion(tokens) == tokens.begin();
}

std::string insertAfterVersion(const std::string& source, const std::string& text) {
    const Tokens tokens = tokensOf(source);
    // Before a token, for a line may end within a comment.
    auto next = tokens.begin();
    if (const auto version = findVersion(tokens); version != tokens.end()) {
        const char* lineEnd = std::find(version->data(), source.data() + source.size(), '\n');
        next = std::find_if(version, tokens.end(),
                            [lineEnd](std::string_view token) { return token.data() > lineEnd; });
    }
    const std::string_view whole = source;
    const auto before =
        next == tokens.end()
            ? whole
            : whole.substr(0, static_cast<std::size_t>(next->data() - whole.data()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    return std::string(before) + "\n" + text + "#line " + std::to_string(line) + "\n" +
           source.substr(before.size());
}

std::string typeOfInput(const std::string& source, const std::string& name) {
    const Tokens tokens = tokensOf(source);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i] != "in") {
            continue;
        }
        std::size_t k = i + 1;
        while (isWord(at(tokens, k)) && !isInputType(tokens[k])) {
            ++k;  // a qualifier, such as highp
        }
        const std::string_view type = at(tokens, k);
        bool isListed = false;
        do {
            isListed |= at(tokens, k + 1) == name;
            k += 2;
        } while (at(tokens, k) == ",");
        if (isListed && isInputType(type) && at(tokens, k) == ";") {
            return std::string(type);
        }
    }
    return "";
}

bool definesFunction(const std::string& source, const std::string& name) {
    const Tokens tokens = tokensOf(source);
    for (std::size_t i = 1; i < tokens.size(); ++i) {
        if (tokens[i] == name && isWord(tokens[i - 1]) && at(tokens, i + 1) == "(") {
            const auto close = std::find(tokens.begin() + static_cast<long>(i), tokens.end(), ")");
            if (at(tokens, static_cast<std::size_t>(close - tokens.begin()) + 1) == "{") {
                return true;
            }
        }
    }
    return false;
}

}  // namespace cg
