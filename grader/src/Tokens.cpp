#include "Tokens.h"

#include <algorithm>
#include <cctype>

namespace grader {

namespace {

bool isNameStart(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool isNamePart(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Reads tokens one after the other, comments and blanks passed over.
class Scanner {
public:
    explicit Scanner(const std::string& text) : text_(text) {}

    /// False at the end.
    bool next(Token& token) {
        auto& [kind, word] = token;
        skip();
        if (at_ >= text_.size())
            return false;
        const std::size_t from = at_;
        const char c = text_[at_];
        if (isNameStart(c)) {
            while (at_ < text_.size() && isNamePart(text_[at_]))
                ++at_;
            word = text_.substr(from, at_ - from);
            kind = "NAME";
        } else if (std::isdigit(static_cast<unsigned char>(c))) {
            const auto separates = [&] {  // 1'000
                return text_[at_] == '\'' && at_ + 1 < text_.size() && isNamePart(text_[at_ + 1]);
            };
            while (at_ < text_.size() &&
                   (isNamePart(text_[at_]) || text_[at_] == '.' || separates()))
                ++at_;
            word = text_.substr(from, at_ - from);
            kind = "NUMBER";
        } else if (c == '"' || c == '\'') {
            for (++at_; at_ < text_.size() && text_[at_] != c; ++at_)
                at_ += text_[at_] == '\\';
            at_ = std::min(at_ + 1, text_.size());
            word = text_.substr(from, at_ - from);
            kind = "STRING";
        } else {
            ++at_;
            kind = word = std::string(1, c);
        }
        return true;
    }

private:
    void skip() {
        while (at_ < text_.size()) {
            if (std::isspace(static_cast<unsigned char>(text_[at_])))
                ++at_;
            else if (text_.compare(at_, 2, "//") == 0)
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (text_.compare(at_, 2, "/*") == 0)
                at_ = std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
            else
                return;
        }
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

}  // namespace

void forEachToken(const std::string& text, const std::function<void(const Token&)>& take) {
    Token token;
    for (Scanner scanner(text); scanner.next(token);)
        take(token);
}

std::vector<Token> tokensIn(const std::string& text) {
    std::vector<Token> tokens;
    forEachToken(text, [&](const Token& token) { tokens.push_back(token); });
    return tokens;
}

std::string wordsOf(const std::string& text) {
    std::string words;
    forEachToken(text, [&](const Token& token) { words += token.word + " "; });
    return words;
}

}  // namespace grader
