#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace grader {

/// Fingerprints of a text: hashes of runs of tokens, of which the smallest in every window is kept
/// (winnowing: Schleimer, Wilkerson, Aiken, "Winnowing: local algorithms for document
/// fingerprinting", SIGMOD 2003). Names, numbers, strings, comments and layout make no difference,
/// so that renaming does not hide a copy. Two texts that share a run of kSureTokens tokens share a
/// fingerprint.
/// In ascending order, none twice.
using Fingerprints = std::vector<std::uint64_t>;
inline constexpr std::size_t kRunTokens = 12, kWindow = 8;
inline constexpr std::size_t kSureTokens = kRunTokens + kWindow - 1;

Fingerprints fingerprintsOf(const std::string& text);

/// Of several texts; and those of the first that the second lacks.
Fingerprints joined(const Fingerprints& first, const Fingerprints& second);
Fingerprints without(const Fingerprints& first, const Fingerprints& second);

/// The kinds of the tokens of a text in C++ or GLSL: "if", "(", "NAME", "NUMBER", …
std::vector<std::string> tokensOf(const std::string& text);

/// A submission to be compared.
struct Print {
    std::string name;
    Fingerprints own;   ///< of the student's files, without what the starter has
    std::string exact;  ///< hash of the words of all files
};

struct Likeness {
    std::string first, second;
    double share = 0;        ///< of the fingerprints of the one that has fewer
    bool identical = false;  ///< comments and layout aside
};

/// Pairs that are nearly identical, the most alike first. What many share is how the thing is
/// written, and not counted: fingerprints that more than a tenth of all have (and more than five).
/// In each pair is one of the first `many`.
std::vector<Likeness> nearlyIdentical(const std::vector<Print>& prints,
                                      std::size_t many = std::numeric_limits<std::size_t>::max());

}  // namespace grader
