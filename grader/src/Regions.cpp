#include "Regions.h"

#include <algorithm>
#include <vector>

namespace grader {

namespace {

struct Span {
    std::string id;
    std::size_t begin, end;  // of the inside: whole lines
};

constexpr std::size_t kLongestId = 64;
const std::string kBegin = "// BEGIN TODO(", kEnd = "// END TODO(";

/// Where the marks `before`id) stand, by id.
std::map<std::string, std::vector<std::size_t>> marksOf(const std::string& text,
                                                        const std::string& before) {
    std::map<std::string, std::vector<std::size_t>> marks;
    for (auto at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
        const std::string rest = text.substr(at + before.size(), kLongestId + 1);
        const std::string id = rest.substr(0, rest.find(')'));
        if (!id.empty() && id.size() < rest.size() && id.find('\n') == std::string::npos)
            marks[id].push_back(at);
    }
    return marks;
}

/// In time that grows with the text alone, however many marks a stranger has put into it.
std::vector<Span> spansOf(const std::string& text) {
    const auto opened = marksOf(text, kBegin), closed = marksOf(text, kEnd);
    std::map<std::size_t, std::string> openings;
    for (const auto& [id, places] : opened)
        if (places.size() == 1 && closed.contains(id))
            openings[places.front()] = id;
    std::vector<Span> spans;
    std::size_t line = 0, end = 0;
    for (const auto& [at, id] : openings) {
        if (at < end)
            continue;  // regions do not nest
        if (line <= at)
            line = text.find('\n', at);
        const auto& ends = closed.at(id);
        const auto close = std::upper_bound(ends.begin(), ends.end(), line);
        if (line == std::string::npos || close == ends.end())
            continue;
        end = *close;
        spans.push_back({id, line + 1, text.rfind('\n', end) + 1});
    }
    return spans;
}

}  // namespace

std::map<std::string, std::string> regionsOf(const std::string& text) {
    std::map<std::string, std::string> regions;
    for (const Span& span : spansOf(text))
        regions[span.id] = text.substr(span.begin, span.end - span.begin);
    return regions;
}

std::optional<std::string> withRegion(const std::string& text, const std::string& id,
                                      const std::string& body) {
    for (const Span& span : spansOf(text))
        if (span.id == id)
            return text.substr(0, span.begin) + body + text.substr(span.end);
    return std::nullopt;
}

int lineOfRegion(const std::string& text, const std::string& id) {
    const std::size_t at = text.find(kBegin + id + ")");
    if (at == std::string::npos)
        return 0;
    return 1 + static_cast<int>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

std::string outsideRegions(const std::string& text) {
    std::string outside;
    std::size_t from = 0;
    for (const Span& span : spansOf(text)) {
        outside += text.substr(from, span.begin - from);
        from = span.end;
    }
    return outside + text.substr(from);
}

}  // namespace grader
