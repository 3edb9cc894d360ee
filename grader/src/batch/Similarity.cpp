#include "batch/Similarity.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace grader {

namespace {

constexpr double kAlike = 0.8;
constexpr std::size_t kFewestFingerprints = 8;  // of less nothing can be said

const std::set<std::string> kKept = {
    "auto",   "bool",   "break",    "case", "const", "continue", "do",   "double", "else",
    "float",  "for",    "if",       "int",  "mat2",  "mat3",     "mat4", "return", "static",
    "struct", "switch", "unsigned", "vec2", "vec3",  "vec4",     "void", "while"};

bool isNameStart(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool isNamePart(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Reads tokens one after the other, comments and blanks passed over.
class Scanner {
public:
    explicit Scanner(const std::string& text) : text_(text) {}

    /// False at the end. `kind` is what the token is, `word` what it says.
    bool next(std::string& kind, std::string& word) {
        skip();
        if (at_ >= text_.size())
            return false;
        const std::size_t from = at_;
        const char c = text_[at_];
        if (isNameStart(c)) {
            while (at_ < text_.size() && isNamePart(text_[at_]))
                ++at_;
            word = text_.substr(from, at_ - from);
            kind = kKept.contains(word) ? word : "NAME";
        } else if (std::isdigit(static_cast<unsigned char>(c))) {
            while (at_ < text_.size() && (isNamePart(text_[at_]) || text_[at_] == '.'))
                ++at_;
            word = text_.substr(from, at_ - from);
            kind = "NUMBER";
        } else if (c == '"' || c == '\'') {
            for (++at_; at_ < text_.size() && text_[at_] != c; ++at_)
                at_ += text_[at_] == '\\';
            at_ = std::min(at_ + 1, text_.size());
            word = text_.substr(from, at_ - from);
            kind = "STRING";
        } else {
            ++at_;
            kind = word = std::string(1, c);
        }
        return true;
    }

private:
    void skip() {
        while (at_ < text_.size()) {
            if (std::isspace(static_cast<unsigned char>(text_[at_])))
                ++at_;
            else if (text_.compare(at_, 2, "//") == 0)
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (text_.compare(at_, 2, "/*") == 0)
                at_ = std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
            else
                return;
        }
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

constexpr std::uint64_t kPrime = 1099511628211ull, kBasis = 14695981039346656037ull;

/// FNV-1a, the same on every machine.
std::uint64_t hashOf(std::uint64_t hash, const std::string& word) {
    for (const char c : word)
        hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
    return (hash ^ 0xff) * kPrime;
}

/// How many of the submissions have each fingerprint.
std::map<std::uint64_t, std::vector<std::size_t>> ownersOf(const std::vector<Print>& prints) {
    std::map<std::uint64_t, std::vector<std::size_t>> owners;
    for (std::size_t i = 0; i < prints.size(); ++i)
        for (const std::uint64_t each : prints[i].own)
            owners[each].push_back(i);
    return owners;
}

}  // namespace

std::vector<std::string> tokensOf(const std::string& text) {
    std::vector<std::string> kinds;
    std::string kind, word;
    for (Scanner scanner(text); scanner.next(kind, word);)
        kinds.push_back(kind);
    return kinds;
}

std::string wordsOf(const std::string& text) {
    std::string words, kind, word;
    for (Scanner scanner(text); scanner.next(kind, word);)
        words += word + " ";
    return words;
}

Fingerprints fingerprintsOf(const std::string& text) {
    const auto tokens = tokensOf(text);
    std::vector<std::uint64_t> runs;
    for (std::size_t i = 0; i + kRunTokens <= tokens.size(); ++i) {
        std::uint64_t hash = kBasis;
        for (std::size_t k = 0; k < kRunTokens; ++k)
            hash = hashOf(hash, tokens[i + k]);
        runs.push_back(hash);
    }
    Fingerprints kept;
    for (std::size_t i = 0; i + kWindow <= runs.size(); ++i)
        kept.insert(*std::min_element(runs.begin() + static_cast<std::ptrdiff_t>(i),
                                      runs.begin() + static_cast<std::ptrdiff_t>(i + kWindow)));
    return kept;
}

std::vector<Likeness> nearlyIdentical(const std::vector<Print>& prints) {
    const std::size_t most = std::max<std::size_t>(5, prints.size() / 10);
    std::vector<std::size_t> counted(prints.size());
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> shared;
    for (const auto& [fingerprint, owners] : ownersOf(prints)) {
        if (owners.size() > most)
            continue;
        for (std::size_t i = 0; i < owners.size(); ++i) {
            ++counted[owners[i]];
            for (std::size_t k = i + 1; k < owners.size(); ++k)
                ++shared[{owners[i], owners[k]}];
        }
    }
    std::map<std::pair<std::size_t, std::size_t>, Likeness> found;
    for (const auto& [pair, count] : shared) {
        const std::size_t fewer = std::min(counted[pair.first], counted[pair.second]);
        const double share = static_cast<double>(count) / static_cast<double>(fewer);
        if (fewer >= kFewestFingerprints && share >= kAlike)
            found[pair] = {prints[pair.first].name, prints[pair.second].name, share, false};
    }
    std::map<std::string, std::vector<std::size_t>> byText;
    for (std::size_t i = 0; i < prints.size(); ++i)
        if (prints[i].own.size() >= kFewestFingerprints)
            byText[prints[i].exact].push_back(i);
    for (const auto& [text, same] : byText)
        for (std::size_t i = 1; i < same.size(); ++i)
            found[{same[0], same[i]}] = {prints[same[0]].name, prints[same[i]].name, 1, true};
    std::vector<Likeness> all;
    for (const auto& [pair, each] : found)
        all.push_back(each);
    std::stable_sort(all.begin(), all.end(), [](const Likeness& a, const Likeness& b) {
        return std::pair(a.identical, a.share) > std::pair(b.identical, b.share);
    });
    return all;
}

}  // namespace grader
