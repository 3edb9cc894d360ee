#include "pull_request/Markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "report/PlainText.h"

namespace grader {

namespace {

constexpr std::size_t kMostFenced = 4000, kMostCommand = 1000;

std::size_t longestRun(const std::string& text, char sign) {
    std::size_t longest = 0, run = 0;
    for (const char c : text) {
        run = c == sign ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    return longest;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

}  // namespace

std::string escapedMarkdown(const std::string& text, std::size_t most) {
    std::string escaped;
    for (const char c : shortened(harmless(text), most)) {
        if (c == '&')
            escaped += "&amp;";
        else if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else if (c == '@')
            escaped += "&#64;";  // or somebody of that name would be told
        else if (std::string("\\`*_{}[]#|~$!").find(c) != std::string::npos)
            escaped += std::string("\\") + c;
        else if (escaped.empty() && std::string("-+=").find(c) != std::string::npos)
            escaped += std::string("\\") + c;  // no list in a list
        else
            escaped += c;
    }
    // Addresses become links by themselves.
    replaceAll(escaped, "://", "&#58;//");
    replaceAll(escaped, "www.", "www&#46;");
    return escaped;
}

std::string fencedMarkdown(const std::string& text) {
    const std::string shown = shortened(harmless(text, true), kMostFenced);
    const std::string fence(std::max<std::size_t>(3, longestRun(shown, '`') + 1), '`');
    return fence + "text\n" + shown + "\n" + fence + "\n";
}

std::string codeMarkdown(const std::string& text) {
    std::string shown = shortened(harmless(text), 200);
    replaceAll(shown, "|", "\\|");  // in a table even code ends there
    const std::string fence(longestRun(shown, '`') + 1, '`');
    const bool padded = shown.starts_with('`') || shown.ends_with('`');
    return padded ? fence + " " + shown + " " + fence : fence + shown + fence;
}

std::string commandData(const std::string& text) {
    std::string data = shortened(harmless(text, true), kMostCommand);
    replaceAll(data, "%", "%25");
    replaceAll(data, "\r", "%0D");
    replaceAll(data, "\n", "%0A");
    return data;
}

std::string commandProperty(const std::string& text) {
    std::string value = commandData(text);
    replaceAll(value, ":", "%3A");
    replaceAll(value, ",", "%2C");
    return value;
}

std::string withoutCommands(const std::string& text) {
    std::random_device random;
    const std::string word = fmt::format("end-{:08x}{:08x}{:08x}", random(), random(), random());
    return fmt::format("::stop-commands::{}\n{}\n::{}::\n", word, text, word);
}

}  // namespace grader
