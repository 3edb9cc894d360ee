#include "Regions.h"

#include <regex>
#include <vector>

namespace grader {

namespace {

struct Span {
    std::string id;
    std::size_t begin, end;  // of the inside: whole lines
};

std::vector<Span> spansOf(const std::string& text) {
    static const std::regex opening(R"([ \t]*// BEGIN TODO\(([\w-]+)\)[^\n]*\n)");
    std::vector<Span> spans;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), opening);
         it != std::sregex_iterator(); ++it) {
        const auto begin = static_cast<std::size_t>(it->position() + it->length());
        const std::string id = (*it)[1];
        const auto close = text.find("// END TODO(" + id + ")", begin);
        if (close == std::string::npos)
            continue;
        const auto line = text.rfind('\n', close);
        spans.push_back({id, begin, line == std::string::npos ? begin : line + 1});
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
