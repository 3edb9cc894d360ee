#pragma once

#include <string>
#include <vector>

#include "batch/Marks.h"
#include "batch/Similarity.h"

namespace grader {

/// A batch for those who read it.
struct Overview {
    const Manifest& manifest;
    const std::vector<Mark>& marks;            ///< by student
    const std::vector<std::string>& notTaken;  ///< what was in the folder and is nobody's
    const std::vector<Likeness>& likenesses;
    const std::vector<std::string>& classIds;  ///< all students, those of other shards, too
    std::uint64_t seed;
    Json environment;  ///< sandbox, compiler, cpu, grader

    std::string json() const;  ///< as grader/RESULT.md describes it
    std::string csv() const;   ///< RFC 4180; a row for each student, a column for each task
};

/// One page that needs nothing but the folders beside it: what an instructor must look at on top,
/// then a table to sort and to filter, how the points are distributed, the checks that most lost,
/// mistakes by frequency, a gallery of every frame, and submissions that are nearly identical.
/// `out`: the folder that it will lie in.
std::string overviewPage(const Overview& overview, const fs::path& out);

/// Submissions of these marks that are nearly identical, with each other or with one of `earlier`
/// (earlierPrints).
std::vector<Likeness> likenessesAmong(const Ledger& ledger, const std::vector<Mark>& marks,
                                      const std::vector<Print>& earlier = {});

/// Writes results.json, results.csv and index.html.
void writeOverview(const Overview& overview, const fs::path& out);

}  // namespace grader
