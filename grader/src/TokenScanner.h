#pragma once

#include <string>

namespace grader {

/// What a token is ("NAME", "NUMBER", "STRING", or the sign itself) and what it says.
struct Token {
    std::string kind, word;
};

/// Reads the tokens of C++ or GLSL one after the other; comments and blanks are passed over. The
/// words of the language are names. The text must outlive it.
class TokenScanner {
public:
    explicit TokenScanner(const std::string& text) : text_(text) {}

    /// False at the end.
    bool next(Token& token);

private:
    void skip();

    const std::string& text_;
    std::size_t at_ = 0;
};

}  // namespace grader
