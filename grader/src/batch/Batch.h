#pragma once

#include "Archive.h"
#include "Grade.h"
#include "batch/Crew.h"
#include "batch/Intake.h"
#include "batch/Keys.h"
#include "batch/Ledger.h"

namespace grader {

/// Grades many submissions of one assignment, several at a time, and remembers each.
///
/// Theory of operation. Each worker is a thread that takes the next submission, largest first, and
/// waits for the sandboxed processes that grade it; it holds one submission's pictures at a time.
/// What is known under the same key (Ledger) is not graded again; where only points or words of the
/// assignment have changed, it is marked again from what is known. A fault of the grader's is tried
/// once more, then said, and never remembered. So is a submission that takes longer than all its
/// parts may take: what was started for it is killed (TimeBox), and a thread that does not even
/// come back then is left behind (Crew). A seed that is not published stays so: the report
/// for a student has no reference that depends on it, and a second one beside the students' folders
/// has all.
class Batch {
public:
    struct Terms {
        std::uint64_t seed = 1;
        Key rules;                  ///< keyOfRules()
        double longestSeconds = 0;  ///< for one submission, then it is a fault of the grader's
        bool stable = false;        ///< each is graded three times, and those that differ are said
    };
    /// All must outlive this.
    Batch(const Grader& grader, const Sandbox& sandbox, const Manifest& manifest,
          const Ledger& ledger, Terms terms);

    /// In the order of the entrants; see Crew::run(). `fresh`: what is known does not count.
    Crew::Done run(const std::vector<Entrant>& entrants, int jobs, bool fresh,
                   const std::atomic<bool>& stop,
                   const std::function<void(const Standing&)>& tell) const;

private:
    Standing standingOf(const Entrant& entrant, bool fresh) const;
    std::optional<Standing> known(const Entrant& entrant, const Key& key) const;
    Standing gradeOnce(const Entrant& entrant, const Key& key) const;
    Print printOf(const std::string& entrant, const Submission& submission) const;
    std::string repeated(const Submission& submission, const AssignmentResult& first) const;
    void writeReports(std::vector<AssignmentResult>& results, const std::string& entrant) const;
    Json markAgain(const std::string& entrant, Json document) const;

    const Grader& grader_;
    const Sandbox& sandbox_;
    const Manifest& manifest_;
    const Ledger& ledger_;
    Terms terms_;
    std::vector<std::string> known_;  ///< assignments
};

}  // namespace grader
