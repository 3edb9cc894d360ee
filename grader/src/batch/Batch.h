#pragma once

#include <atomic>
#include <functional>
#include <mutex>

#include "Archive.h"
#include "Grade.h"
#include "batch/Intake.h"
#include "batch/Ledger.h"

namespace grader {

/// What became of one submission of a batch.
struct Standing {
    std::string entrant;   ///< its name
    std::string status;    ///< of the result document, or "refused", or "grader_error"
    std::string sentence;  ///< why it was refused, or what the grader's fault was
    double points = 0, maxPoints = 0;
    Json result;              ///< the result document; null where there is none
    std::string unstable;     ///< how repeated gradings differ; empty when they agree
    bool fromBefore = false;  ///< nothing that decides it has changed: not graded again
    bool graderFailed() const { return status == "grader_error"; }
};

/// Grades many submissions of one assignment, several at a time, and remembers each.
///
/// Theory of operation. Each worker is a thread that takes the next submission, largest first, and
/// waits for the sandboxed processes that grade it; it holds one submission's pictures at a time.
/// What is known under the same key (Ledger) is not graded again. A fault of the grader's is tried
/// once more, then said, and never remembered. A seed that is not published stays so: the report
/// for a student has no reference that depends on it, and a second one beside the students' folders
/// has all.
class Batch {
public:
    /// `key`: of all that decides results beside the submission itself. `stable`: each is graded
    /// three times, and those that differ are said. All must outlive this.
    Batch(const Grader& grader, const Sandbox& sandbox, const Manifest& manifest,
          const Ledger& ledger, std::uint64_t seed, std::string key, bool stable);

    /// In the order of the entrants, without those that were not begun when `stop` became true.
    /// `tell` is called after each, by one thread at a time.
    std::vector<Standing> run(const std::vector<Entrant>& entrants, int jobs, bool fresh,
                              const std::atomic<bool>& stop,
                              const std::function<void(const Standing&)>& tell) const;

private:
    Standing standingOf(const Entrant& entrant, bool fresh) const;
    Standing gradeOnce(const Entrant& entrant, const std::string& key) const;
    Print printOf(const std::string& entrant, const Submission& submission) const;
    std::string repeated(const Submission& submission, const AssignmentResult& first) const;
    void writeReports(std::vector<AssignmentResult>& results, const std::string& entrant) const;
    std::string keyOf(const Entrant& entrant) const;

    const Grader& grader_;
    const Sandbox& sandbox_;
    const Manifest& manifest_;
    const Ledger& ledger_;
    std::uint64_t seed_;
    std::string key_;
    bool stable_;
    std::vector<std::string> known_;  ///< assignments
};

/// A hash of all that decides results beside the submission: assignment, tests, references,
/// solutions, grader, kit, compiler, sandbox, processor, seed.
std::string keyOfRules(const Toolchain& tools, const Sandbox& sandbox, const Manifest& manifest,
                       std::uint64_t seed);

}  // namespace grader
