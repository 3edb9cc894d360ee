#include "report/PlainText.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "Files.h"

namespace grader {

namespace {

bool startsCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

bool steers(const std::string& sign) {
    static const char* turning[] = {"\u061C", "\u200E", "\u200F", "\u202A", "\u202B", "\u202C",
                                    "\u202D", "\u202E", "\u2066", "\u2067", "\u2068", "\u2069"};
    const auto first = static_cast<unsigned char>(sign[0]);
    return first < 32 || first == 127 ||
           (first == 0xC2 && static_cast<unsigned char>(sign[1]) < 0xA0) ||
           std::find(std::begin(turning), std::end(turning), sign) != std::end(turning);
}

}  // namespace

std::string harmless(std::string text, bool keepLines) {
    for (auto bad = firstInvalidUtf8(text); bad != std::string::npos;
         bad = firstInvalidUtf8(text, bad))
        text[bad] = '?';
    std::string safe;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t size = bytesOf(text.substr(i, 5), 1);
        const std::string sign = text.substr(i, size);
        safe += steers(sign) && !(keepLines && sign == "\n") ? " " : sign;
        i += size;
    }
    return safe;
}

std::string lowered(std::string text) {
    for (char& each : text)
        each = static_cast<char>(std::tolower(static_cast<unsigned char>(each)));
    return text;
}

std::size_t columns(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), startsCharacter));
}

std::size_t bytesOf(const std::string& text, std::size_t most) {
    std::size_t at = 0;
    for (std::size_t seen = 0; at < text.size(); ++at)
        if (startsCharacter(text[at]) && seen++ == most)
            break;
    return at;
}

std::string shortened(const std::string& text, std::size_t most) {
    return columns(text) <= most ? text : text.substr(0, bytesOf(text, most - 1)) + "…";
}

}  // namespace grader
