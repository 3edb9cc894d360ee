#include "package/Leaks.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "Regions.h"
#include "Tokens.h"

namespace grader {

namespace {

/// What the copy has on purpose and is no text: pictures, and signatures of mistakes.
const std::set<std::string> kNoTexts = {".png", ".cbor"};

/// The ASCII in a file of any kind. Zero bytes are left out, so that UTF-16 can be read, too; what
/// else is not printed is blank.
std::string readable(std::string bytes) {
    std::erase(bytes, '\0');
    std::replace_if(
        bytes.begin(), bytes.end(),
        [](unsigned char c) { return c > '~' || (c < ' ' && !std::isspace(c)); }, ' ');
    return bytes;
}

/// Bytes that no text has, in UTF-8 or in Latin-1.
bool isBinary(const std::string& bytes) {
    return std::any_of(bytes.begin(), bytes.end(),
                       [](unsigned char c) { return c < ' ' && !std::isspace(c); });
}

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

/// The runs of a file as it is compiled, and as somebody reads it, comments and strings included.
std::vector<std::string> runsToRead(const std::string& bytes) {
    const std::string text = readable(bytes);
    auto runs = runsOf(opened(wordsOf(text)));
    auto more = runsOf(opened(text));
    runs.insert(runs.end(), std::make_move_iterator(more.begin()),
                std::make_move_iterator(more.end()));
    return runs;
}

using Secrets = std::unordered_map<std::string, std::string>;  // run → where it stands

Secrets secretsOf(const CourseFiles& secret, const CourseFiles& known) {
    std::unordered_set<std::string> open;
    for (const auto& [path, each] : known.files)
        for (std::string& run : runsToRead(each.content))
            open.insert(std::move(run));
    Secrets secrets;
    for (const auto& [path, each] : secret.files)
        for (const auto& [id, body] : regionsOf(each.content))
            for (std::string& run : runsOf(opened(wordsOf(readable(body)))))
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
        std::set<std::string> sources;
        for (const std::string& run : runsToRead(each.content)) {
            const auto found = secrets.find(run);
            if (found != secrets.end() && sources.insert(found->second).second)
                leaks.push_back({path, found->second, run});
        }
    }
    return leaks;
}

std::vector<std::string> unsearchable(const CourseFiles& package) {
    std::vector<std::string> paths;
    for (const auto& [path, each] : package.files)
        if (isBinary(each.content) && !kNoTexts.contains(fs::path(path).extension()))
            paths.push_back(path);
    return paths;
}

}  // namespace grader
