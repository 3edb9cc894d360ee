#include "Portability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "Tokens.h"

namespace grader {

namespace {

bool isCpp(const std::string& name) {
    const std::string kind = fs::path(name).extension().string();
    return kind == ".cpp" || kind == ".h" || kind == ".inl";
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words;
    for (Token& each : tokensIn(text))
        words.push_back(std::move(each.word));
    return words;
}

/// Whether one word comes right after another: "undef near".
bool follows(const std::vector<std::string>& words, const std::string& first,
             const std::string& second) {
    for (std::size_t i = 1; i < words.size(); ++i)
        if (words[i - 1] == first && words[i] == second)
            return true;
    return false;
}

bool holds(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// The constants that POSIX adds to <cmath>.
std::string constantOfPosix(const std::vector<std::string>& words) {
    static const std::set<std::string> all = {
        "M_PI",    "M_PI_2",   "M_PI_4", "M_1_PI", "M_2_PI",  "M_2_SQRTPI", "M_E",
        "M_LOG2E", "M_LOG10E", "M_LN2",  "M_LN10", "M_SQRT2", "M_SQRT1_2"};
    for (const std::string& word : words)
        if (all.contains(word) && !follows(words, "define", word))
            return word;
    return "";
}

/// A header that includes windows.h, there or before it can be used.
std::string headerOfWindows(const std::string& text) {
    for (const char* name :
         {"windows.h", "Windows.h", "GL/gl.h", "GL/glu.h", "GL/glut.h", "GL/freeglut.h"})
        if (text.find(fmt::format("<{}>", name)) != std::string::npos)
            return name;
    return "";
}

std::string lowerCase(std::string text) {
    for (char& each : text)
        each = static_cast<char>(std::tolower(static_cast<unsigned char>(each)));
    return text;
}

}  // namespace

std::vector<std::string> portabilityNotices(const Stage& stage) {
    std::vector<std::string> notices;
    std::string header;
    bool defined = false, undefined = false;
    std::vector<std::pair<std::string, std::vector<std::string>>> files;
    for (const StagedFile& file : stage.files) {
        if (file.role != Role::own || file.origin != "submission" || !isCpp(file.name))
            continue;
        files.emplace_back(file.name, wordsOf(file.content));
        const auto& words = files.back().second;
        header = header.empty() ? headerOfWindows(file.content) : header;
        defined = defined || follows(words, "define", "_USE_MATH_DEFINES");
        undefined = undefined || follows(words, "undef", "near") || follows(words, "undef", "far");
    }
    for (const auto& [name, words] : files) {
        if (const std::string constant = constantOfPosix(words); !constant.empty() && !defined)
            notices.push_back(fmt::format(
                "{} uses {}, which standard C++ and the compiler of Windows do not have: {} works "
                "everywhere, or write #define _USE_MATH_DEFINES before the first #include",
                name, constant,
                constant == "M_PI" ? "std::numbers::pi of <numbers>" : "a constant of <numbers>"));
        if (!header.empty() && !undefined && (holds(words, "near") || holds(words, "far")))
            notices.push_back(fmt::format(
                "{} uses the names near or far, and <{}> is included: on Windows that brings "
                "macros of these names along. Write #undef near and #undef far after it",
                name, header));
    }
    return notices;
}

std::string nameInOtherCase(const std::string& wanted, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (name != wanted && lowerCase(name) == lowerCase(wanted))
            return name;
    return "";
}

}  // namespace grader
