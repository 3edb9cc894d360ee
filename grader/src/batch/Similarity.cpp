#include "batch/Similarity.h"

#include <algorithm>
#include <map>

#include "Tokens.h"

namespace grader {

namespace {

constexpr double kAlike = 0.8;
constexpr std::size_t kFewestFingerprints = 8;  // of less nothing can be said

const std::set<std::string> kKept = {
    "auto",   "bool",   "break",    "case", "const", "continue", "do",   "double", "else",
    "float",  "for",    "if",       "int",  "mat2",  "mat3",     "mat4", "return", "static",
    "struct", "switch", "unsigned", "vec2", "vec3",  "vec4",     "void", "while"};

/// A word of the language is of its own kind, every other name is one like another.
std::string kindOf(const Token& token) {
    return kKept.contains(token.word) ? token.word : token.kind;
}

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
    for (const Token& each : tokensIn(text))
        kinds.push_back(kindOf(each));
    return kinds;
}

std::string wordsOf(const std::string& text) {
    std::string words;
    for (const Token& each : tokensIn(text))
        words += each.word + " ";
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

std::vector<Likeness> nearlyIdentical(const std::vector<Print>& prints, std::size_t many) {
    const std::size_t most = std::max<std::size_t>(5, prints.size() / 10);
    std::vector<std::size_t> counted(prints.size());
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> shared;
    for (const auto& [fingerprint, owners] : ownersOf(prints)) {
        if (owners.size() > most)
            continue;
        for (std::size_t i = 0; i < owners.size(); ++i) {
            ++counted[owners[i]];
            for (std::size_t k = i + 1; owners[i] < many && k < owners.size(); ++k)
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
        for (std::size_t i = 1; same[0] < many && i < same.size(); ++i)
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
