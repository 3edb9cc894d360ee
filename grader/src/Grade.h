#pragma once

#include <mutex>
#include <set>

#include "Observe.h"
#include "References.h"
#include "Result.h"

namespace grader {

/// Grades: collect → stage → build → observe → judge. Reports are made elsewhere.
class Grader {
public:
    Grader(const Toolchain& tools, const Sandbox& sandbox, const Renderer& renderer = {})
        : tools_(tools),
          sandbox_(sandbox),
          builder_(tools, sandbox),
          observer_(tools, sandbox, renderer) {}

    /// One assignment of a submission. Throws Error for the grader's own faults only.
    AssignmentResult grade(const Manifest& manifest, const Submission& submission,
                           std::uint64_t seed) const;

    /// The result of a submission that cannot be taken as it is, which loses everything.
    AssignmentResult refuse(const Manifest& manifest, std::uint64_t seed,
                            std::vector<Diagnostic> why) const;

    /// The same from a stage: build, observe, judge, with what its tasks need mended and mistakes
    /// recognised. `stage` is changed where another file had to be taken.
    AssignmentResult gradeStaged(const Manifest& manifest, Stage& stage, std::uint64_t seed) const;

    /// One stage as it is, without looking for prerequisites. What proves the course consistent,
    /// and the core of grade().
    struct StageResult {
        BuildResult build;
        std::vector<CheckResult> checks;
        protocol::GraphicsInfo graphics;
        bool couldDraw = true;  ///< else OpenGL was at fault, before the submission ran
        double buildSeconds = 0, observeSeconds = 0;
    };
    StageResult gradeStage(const Manifest& manifest, const Stage& stage, std::uint64_t seed) const;

    /// The frames alone; no checks when it does not build.
    std::vector<CheckResult> gradeFrames(const Manifest& manifest, const Stage& stage,
                                         std::uint64_t seed) const;

    /// The frames that a stage draws; throws Error when it does not build or a frame fails.
    std::map<std::string, Picture> draw(const Manifest& manifest, const Stage& stage,
                                        std::uint64_t seed) const;

    /// Ids of all checks there are.
    std::set<std::string> checkIds(const Manifest& manifest) const;

    /// The stage of the starter or of the solution ("assignments", "solutions").
    Stage stageOf(const Manifest& manifest, const std::string& tree) const;

    /// What the frames are scored by: with the published seed from reference_images/, with another
    /// from what solution, starter and mistakes draw now.
    const FrameRules& rules(const Manifest& manifest, std::uint64_t seed) const;
    /// Ids of the frames whose references are the published ones with this seed, too: no secret.
    const std::set<std::string>& publicFrames(const Manifest& manifest, std::uint64_t seed) const;

    /// How known mistakes show themselves, as stored; throws Error when they are not.
    const Signatures& signatures(const Manifest& manifest) const;

    const Toolchain& tools() const { return tools_; }

private:
    StageResult gradeOnce(const Manifest& manifest, const Stage& stage, std::uint64_t seed) const;
    std::vector<CheckResult> unjudged(const Manifest& manifest) const;
    void fillIn(AssignmentResult& result, const Manifest& manifest, const StageResult& graded,
                std::uint64_t seed) const;

    const Toolchain& tools_;
    const Sandbox& sandbox_;
    Builder builder_;
    Observer observer_;
    mutable std::mutex truthMutex_;
    mutable std::map<std::pair<std::string, std::uint64_t>, FrameRules> rules_;
    mutable std::map<std::pair<std::string, std::uint64_t>, std::set<std::string>> publicFrames_;
    mutable std::map<std::string, Signatures> signatures_;  // by assignment
};

/// The seconds after which grading one submission has ended, whatever it does: the sum of all
/// limits of its parts. What takes longer is held up by a fault of the grader's or of the machine.
double longestGrading(const Manifest& manifest);

}  // namespace grader
