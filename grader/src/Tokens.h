#pragma once

#include <string>
#include <vector>

namespace grader {

/// A token of C++ or GLSL, or what comes nearest to it in another text.
struct Token {
    std::string kind;  ///< "NAME" (words of the language, too), "NUMBER", "STRING", or a sign
    std::string word;  ///< what it says
};

/// The tokens of a text; comments and layout are passed over. Any text has tokens.
std::vector<Token> tokensIn(const std::string& text);

}  // namespace grader
