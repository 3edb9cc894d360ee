#include "Regions.h"

#include <vector>

namespace grader {

namespace {

struct Span {
    std::string id;
    std::size_t begin, end;  // of the inside: whole lines
};

std::vector<Span> spansOf(const std::string& text) {
    static const std::string opening = "// BEGIN TODO(", closing = "// END TODO(";
    std::vector<Span> spans;
    for (auto at = text.find(opening); at != std::string::npos; at = text.find(opening, at + 1)) {
        const auto name = at + opening.size();
        const auto line = text.find('\n', at);
        const auto parenthesis = text.find(')', name);
        if (line == std::string::npos || parenthesis > line)
            continue;
        const std::string id = text.substr(name, parenthesis - name);
        const std::string mark = opening + id + ")";
        const auto close = text.find(closing + id + ")", line);
        if (id.empty() || close == std::string::npos || text.find(mark) != text.rfind(mark))
            continue;
        spans.push_back({id, line + 1, text.rfind('\n', close) + 1});
        at = close;  // regions do not nest
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
