#include "package/Leaks.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "Regions.h"
#include "Tokens.h"

namespace grader {

namespace {

/// What hides code from a scanner of tokens: quotes around it, line ends written out in strings,
/// and signs of comments.
std::string opened(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '"' || c == '\'' || c == '`'; }, ' ');
    for (const std::string_view sign : {"\\n", "//", "/*", "*/"})
        for (std::size_t at = 0; (at = text.find(sign, at)) != std::string::npos;)
            text.replace(at, sign.size(), " ");
    return text;
}

std::string withoutComments(const std::string& text) {
    std::string words;
    for (const Token& each : tokensIn(text))
        words += each.word + " ";
    return words;
}

/// All runs of kLeakTokens tokens, each as its words.
std::vector<std::string> runsOf(const std::string& text) {
    const auto tokens = tokensIn(text);
    std::vector<std::string> runs;
    for (std::size_t i = 0; i + kLeakTokens <= tokens.size(); ++i) {
        std::string run;
        for (std::size_t k = i; k < i + kLeakTokens; ++k)
            run += tokens[k].word + " ";
        runs.push_back(std::move(run));
    }
    return runs;
}

/// The runs of a text as it is compiled, and as somebody reads it, comments and strings included.
std::vector<std::string> runsToRead(const std::string& text) {
    auto runs = runsOf(opened(withoutComments(text)));
    auto more = runsOf(opened(text));
    runs.insert(runs.end(), std::make_move_iterator(more.begin()),
                std::make_move_iterator(more.end()));
    return runs;
}

bool isText(const std::string& content) {
    return firstInvalidUtf8(content) == std::string::npos;
}

using Secrets = std::unordered_map<std::string, std::string>;  // run → where it stands

Secrets secretsOf(const CourseFiles& secret, const CourseFiles& known) {
    std::unordered_set<std::string> open;
    for (const auto& [path, each] : known.files)
        if (isText(each.content))
            for (std::string& run : runsToRead(each.content))
                open.insert(std::move(run));
    Secrets secrets;
    for (const auto& [path, each] : secret.files)
        for (const auto& [id, body] : regionsOf(each.content))
            for (std::string& run : runsOf(opened(withoutComments(body))))
                if (!open.contains(run))
                    secrets.emplace(std::move(run), path + ", region " + id);
    return secrets;
}

}  // namespace

std::vector<Leak> leaksOf(const CourseFiles& package, const CourseFiles& secret,
                          const CourseFiles& known) {
    const Secrets secrets = secretsOf(secret, known);
    std::vector<Leak> leaks;
    for (const auto& [path, each] : package.files) {
        if (!isText(each.content))
            continue;
        std::set<std::string> sources;
        for (const std::string& run : runsToRead(each.content)) {
            const auto found = secrets.find(run);
            if (found != secrets.end() && sources.insert(found->second).second)
                leaks.push_back({path, found->second, run});
        }
    }
    return leaks;
}

}  // namespace grader
