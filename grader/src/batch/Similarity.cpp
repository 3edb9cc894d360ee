#include "batch/Similarity.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>

#include "Tokens.h"
#include "subject/Evidence.h"

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

/// Who has which fingerprint. What many have is how the thing is written, and nobody's.
class Owners {
public:
    explicit Owners(const std::vector<Print>& prints)
        : most_(std::max<std::size_t>(5, prints.size() / 10)) {
        for (std::size_t i = 0; i < prints.size(); ++i)
            for (const std::uint64_t each : prints[i].own)
                all_.emplace_back(each, i);
        std::sort(all_.begin(), all_.end());
    }

    using Owned = std::pair<std::uint64_t, std::size_t>;

    /// In the order of the prints.
    std::span<const Owned> of(std::uint64_t fingerprint) const {
        const auto first = std::lower_bound(all_.begin(), all_.end(), Owned{fingerprint, 0});
        const auto end = std::upper_bound(
            first, all_.end(), Owned{fingerprint, std::numeric_limits<std::size_t>::max()});
        const std::span<const Owned> owners(first, end);
        return owners.size() > most_ ? std::span<const Owned>() : owners;
    }

private:
    std::size_t most_;
    std::vector<Owned> all_;
};

using Found = std::map<std::pair<std::size_t, std::size_t>, Likeness>;

void findShared(const std::vector<Print>& prints, std::size_t many, Found& found) {
    const Owners owners(prints);
    std::vector<std::size_t> counted;
    for (const Print& print : prints)
        counted.push_back(static_cast<std::size_t>(
            std::count_if(print.own.begin(), print.own.end(),
                          [&](std::uint64_t each) { return !owners.of(each).empty(); })));
    for (std::size_t i = 0; i < std::min(many, prints.size()); ++i) {
        std::vector<std::size_t> shared(prints.size());
        for (const std::uint64_t each : prints[i].own)
            for (const auto& [fingerprint, owner] : owners.of(each))
                ++shared[owner];
        for (std::size_t k = i + 1; k < prints.size(); ++k) {
            const std::size_t fewer = std::min(counted[i], counted[k]);
            const double share = static_cast<double>(shared[k]) / static_cast<double>(fewer);
            if (fewer >= kFewestFingerprints && share >= kAlike)
                found[{i, k}] = {prints[i].name, prints[k].name, share, false};
        }
    }
}

void findIdentical(const std::vector<Print>& prints, std::size_t many, Found& found) {
    std::map<std::string, std::vector<std::size_t>> byText;
    for (std::size_t i = 0; i < prints.size(); ++i)
        if (prints[i].own.size() >= kFewestFingerprints)
            byText[prints[i].exact].push_back(i);
    for (const auto& [text, same] : byText)
        for (std::size_t i = 1; same[0] < many && i < same.size(); ++i)
            found[{same[0], same[i]}] = {prints[same[0]].name, prints[same[i]].name, 1, true};
}

}  // namespace

std::vector<std::string> tokensOf(const std::string& text) {
    std::vector<std::string> kinds;
    for (const Token& each : tokensIn(text))
        kinds.push_back(kindOf(each));
    return kinds;
}

Fingerprints fingerprintsOf(const std::string& text) {
    const auto tokens = tokensOf(text);
    std::vector<std::uint64_t> runs;
    for (std::size_t i = 0; i + kRunTokens <= tokens.size(); ++i) {
        std::string run;
        for (std::size_t k = 0; k < kRunTokens; ++k)
            run += tokens[i + k] + '\xff';
        runs.push_back(judge::hashOf(run));  // the same in every year's prints
    }
    Fingerprints kept;
    for (std::size_t i = 0; i + kWindow <= runs.size(); ++i)
        kept.push_back(*std::min_element(runs.begin() + static_cast<std::ptrdiff_t>(i),
                                         runs.begin() + static_cast<std::ptrdiff_t>(i + kWindow)));
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    return kept;
}

Fingerprints joined(const Fingerprints& first, const Fingerprints& second) {
    Fingerprints all;
    std::set_union(first.begin(), first.end(), second.begin(), second.end(),
                   std::back_inserter(all));
    return all;
}

Fingerprints without(const Fingerprints& first, const Fingerprints& second) {
    Fingerprints left;
    std::set_difference(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(left));
    return left;
}

std::vector<Likeness> nearlyIdentical(const std::vector<Print>& prints, std::size_t many) {
    Found found;
    findShared(prints, many, found);
    findIdentical(prints, many, found);
    std::vector<Likeness> all;
    for (const auto& [pair, each] : found)
        all.push_back(each);
    std::stable_sort(all.begin(), all.end(), [](const Likeness& a, const Likeness& b) {
        return std::pair(a.identical, a.share) > std::pair(b.identical, b.share);
    });
    return all;
}

}  // namespace grader
