#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "Files.h"
#include "Mistakes.h"
#include "recognise/Thumbnail.h"
#include "subject/Evidence.h"

namespace grader {

using judge::Evidence;

/// Whether two answers to one request are the same but for rounding. Of "shares", one in a hundred
/// may differ; numbers may by a thousandth, of themselves where they are above 1.
bool agree(const Evidence& a, const Evidence& b);

/// Answers by request.
using Answers = std::map<std::string, Evidence>;

/// How a known mistake shows itself: what is otherwise than with a right program.
struct Signature {
    std::string mistake, region, says, common, section;  ///< as in mistakes.json
    std::set<std::string> loses;                         ///< ids of the tasks that lose points
    Answers answers;                                     ///< where they differ from the right ones
    std::map<std::string, Thumbnail> frames;  ///< by frame, where they differ from the reference
};

/// The signatures of an assignment, stored beside its reference images, so that a student's copy
/// needs no solutions. They hold answers to public tests only.
struct Signatures {
    Answers right;
    std::vector<Signature> mistakes;

    /// Throws Error when the file is missing or not what save() writes.
    static Signatures load(const fs::path& file);
    /// CBOR; the same signatures give the same bytes.
    void save(const fs::path& file) const;
};

/// What public tests asked, and what the answers were.
Answers answersOf(const std::vector<CheckResult>& checks);

/// The signature of a mistake from its graded checks.
Signature signatureOf(const Mistake& mistake, const Answers& right,
                      const std::vector<CheckResult>& checks);

/// Ids of the mistakes of which the two say something else, beyond rounding; "the solution" when
/// the right answers differ.
std::vector<std::string> differing(const Signatures& a, const Signatures& b);

}  // namespace grader
