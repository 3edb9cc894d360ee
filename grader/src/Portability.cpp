#include "Portability.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "Tokens.h"
#include "report/PlainText.h"

namespace grader {

namespace {

bool isCpp(const std::string& name) {
    const std::string kind = fs::path(name).extension().string();
    return kind == ".cpp" || kind == ".h" || kind == ".inl";
}

/// What a file says of names that are elsewhere not what they are here.
struct Names {
    std::vector<std::string> constants;  ///< that POSIX adds to <cmath>, by their first use
    std::set<std::string> defined;       ///< by the file itself
    bool nearOrFar = false, undefined = false;
};

Names namesIn(const std::string& text) {
    static const std::set<std::string> ofPosix = {
        "M_PI",    "M_PI_2",   "M_PI_4", "M_1_PI", "M_2_PI",  "M_2_SQRTPI", "M_E",
        "M_LOG2E", "M_LOG10E", "M_LN2",  "M_LN10", "M_SQRT2", "M_SQRT1_2"};
    Names names;
    std::string before;
    forEachToken(text, [&](const Token& token) {
        const std::string& word = token.word;
        const bool nearOrFar = word == "near" || word == "far";
        if (ofPosix.contains(word))
            names.constants.push_back(word);
        if (before == "define" && (ofPosix.contains(word) || word == "_USE_MATH_DEFINES"))
            names.defined.insert(word);
        names.nearOrFar = names.nearOrFar || nearOrFar;
        names.undefined = names.undefined || (nearOrFar && before == "undef");
        before = word;
    });
    return names;
}

/// The first constant that is used and not defined; empty when there is none.
std::string constantOfPosix(const Names& names) {
    for (const std::string& each : names.constants)
        if (!names.defined.contains(each))
            return each;
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

}  // namespace

std::vector<std::string> portabilityNotices(const Stage& stage) {
    std::vector<std::string> notices;
    std::string header;
    bool defined = false, undefined = false;
    std::vector<std::pair<std::string, Names>> files;
    for (const StagedFile& file : stage.files) {
        if (file.role != Role::own || file.origin != "submission" || !isCpp(file.name))
            continue;
        files.emplace_back(file.name, namesIn(file.content));
        const Names& names = files.back().second;
        header = header.empty() ? headerOfWindows(file.content) : header;
        defined = defined || names.defined.contains("_USE_MATH_DEFINES");
        undefined = undefined || names.undefined;
    }
    for (const auto& [name, names] : files) {
        if (const std::string constant = constantOfPosix(names); !constant.empty() && !defined)
            notices.push_back(fmt::format(
                "{} uses {}, which standard C++ and the compiler of Windows do not have: {} works "
                "everywhere, or write #define _USE_MATH_DEFINES before the first #include",
                name, constant,
                constant == "M_PI" ? "std::numbers::pi of <numbers>" : "a constant of <numbers>"));
        if (!header.empty() && !undefined && names.nearOrFar)
            notices.push_back(fmt::format(
                "{} uses the names near or far, and <{}> is included: on Windows that brings "
                "macros of these names along. Write #undef near and #undef far after it",
                name, header));
    }
    return notices;
}

std::string nameInOtherCase(const std::string& wanted, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (name != wanted && lowered(name) == lowered(wanted))
            return name;
    return "";
}

}  // namespace grader
