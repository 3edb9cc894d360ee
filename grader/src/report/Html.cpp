#include "report/Html.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/PlainText.h"
#include "report/Words.h"

namespace grader {

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char each : harmless(text, true)) {
        switch (each) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += each;
        }
    }
    return safe;
}

std::string base64(const std::string& bytes) {
    static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group =
                group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string markOf(Status status) {
    return fmt::format(
        "<span class=\"mark {0}\" title=\"{1}\"><span aria-hidden=\"true\">{2}</span>"
        "<span class=\"unseen\">{1}</span></span> ",
        judge::toString(status), nameOf(status), symbolOf(status));
}

std::string barOf(double points, double most) {
    const double share = most > 0 ? std::clamp(points / most, 0.0, 1.0) : 1;
    return fmt::format(
        "<svg class=\"bar\" viewBox=\"0 0 100 4\" preserveAspectRatio=\"none\" "
        "aria-hidden=\"true\">"
        "<rect class=\"track\" width=\"100\" height=\"4\"/>"
        "<rect class=\"filled\" width=\"{:.1f}\" height=\"4\"/></svg>",
        100 * share);
}

std::string pictureOf(const fs::path& file, const std::string& className, const std::string& alt) {
    return fmt::format("<img class=\"{}\" alt=\"{}\" src=\"data:image/png;base64,{}\">", className,
                       escaped(alt), base64(readFile(file)));
}

}  // namespace grader
