#pragma once

#include <functional>
#include <string>
#include <vector>

namespace grader {

/// A token of C++ or GLSL, or what comes nearest to it in another text.
struct Token {
    std::string kind;  ///< "NAME" (words of the language, too), "NUMBER", "STRING", or a sign
    std::string word;  ///< what it says
};

/// Hands on the tokens of a text, one after the other; comments and layout are passed over. Any
/// text has tokens.
void forEachToken(const std::string& text, const std::function<void(const Token&)>& take);

/// All of them: a hundred times the text in memory, if it is one of signs.
std::vector<Token> tokensIn(const std::string& text);

/// The words of these, a space after each: a text without comments and layout.
std::string wordsOf(const std::string& text);

}  // namespace grader
