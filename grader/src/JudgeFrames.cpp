#include "JudgeFrames.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace grader {

namespace {

CheckResult checkOf(const Manifest& manifest, const Frame& frame) {
    CheckResult check;
    check.id = frame.id;
    check.kind = "frame";
    check.task = frame.task;
    check.title = frame.title;
    check.maxPoints = frame.points;
    check.hint = manifest.task(frame.task)->hint;
    for (const Feature& feature : frame.features)
        check.features.push_back({feature.id, feature.title, 0, feature.points, "", Picture{}});
    return check;
}

/// Scores one frame. Whole-frame faults of earlier frames are in `charged`.
class FrameJudge {
public:
    FrameJudge(const Manifest& manifest, const Frame& frame, const FrameRule& rule,
               std::set<std::string>& charged)
        : manifest_(manifest), frame_(frame), rule_(rule), charged_(charged) {}

    void judge(FrameOutcome outcome, CheckResult& check) {
        check.todos = outcome.todos;
        if (outcome.verdict.status != Status::pass) {
            check.status = outcome.verdict.status;
            check.message = outcome.verdict.message;
            return;
        }
        FrameScore score = rule_.score(outcome.picture);
        award(check, score);
        markUnimplemented(manifest_, check);
        if (check.maxPoints == 0 && check.status == Status::fail)
            check.status = Status::pass;  // the unfilled region belongs to another task
        if (check.full()) {
            check.message.clear();
            check.hint.clear();
        } else if (outcome.undrawn > 0) {
            check.message += fmt::format("{}{:.1f} % of the picture was neither cleared nor drawn",
                                         check.message.empty() ? "" : "; ",
                                         100.0 * outcome.undrawn / (frame_.width * frame_.height));
        }
        check.pictures = FramePictures{
            std::move(outcome.picture), rule_.truth().reference, {}, std::move(score)};
    }

private:
    /// A frame without points is shown only, and must not take the one charge for a fault.
    double shareKept(const FrameScore& score) {
        return score.fault && frame_.points > 0 && charged_.insert(score.fault->id).second
                   ? 1 - kFaultCharge
                   : 1.0;
    }

    void award(CheckResult& check, const FrameScore& score) {
        const double kept = shareKept(score);
        if (check.features.empty()) {
            check.points = kept * score.score * check.maxPoints;
            check.message = score.sentence;
            check.status = statusOf(kept * score.score, check);
            return;
        }
        double share = 0;
        std::vector<std::string> sentences;
        if (score.fault || !score.sizeMatches)
            sentences.push_back(score.sentence);
        for (FeatureResult& feature : check.features) {
            const auto index = static_cast<std::size_t>(
                std::find_if(score.features.begin(), score.features.end(),
                             [&](const FeatureScore& each) { return each.id == feature.id; }) -
                score.features.begin());
            const FeatureScore& found = score.features.at(index);
            feature.points = kept * found.score * feature.maxPoints;
            check.points += feature.points;
            share += found.score;
            if (found.score < 1) {
                feature.mask = rule_.maskOf(index);
                feature.message = found.sentence;
                sentences.push_back(found.sentence);
            }
        }
        check.message = fmt::format("{}", fmt::join(sentences, "; "));
        check.status = statusOf(kept * share / static_cast<double>(check.features.size()), check);
    }

    /// A frame without points is shown and never scored. It counts as failed only for
    /// markUnimplemented(), which tells an unfilled region.
    Status statusOf(double share, const CheckResult& check) const {
        if (check.maxPoints == 0)
            return check.todos.empty() ? Status::pass : Status::fail;
        return share >= 1 ? Status::pass : share > 0 ? Status::partial : Status::fail;
    }

    const Manifest& manifest_;
    const Frame& frame_;
    const FrameRule& rule_;
    std::set<std::string>& charged_;
};

}  // namespace

void markUnimplemented(const Manifest& manifest, CheckResult& check) {
    if (check.status != Status::fail)
        return;
    const Task& task = *manifest.task(check.task);
    for (const std::string& id : check.todos) {
        const bool needed = std::any_of(
            task.needs.begin(), task.needs.end(),
            [&](const std::string& need) { return need.substr(need.find('/') + 1) == id; });
        if (id != task.id && !needed)
            continue;
        check.status = Status::notImplemented;
        check.message = "`" + id + "` is not implemented yet";
        return;
    }
}

std::vector<CheckResult> frameChecks(const Manifest& manifest) {
    std::vector<CheckResult> all;
    for (const Frame& frame : manifest.frames)
        all.push_back(checkOf(manifest, frame));
    return all;
}

std::vector<CheckResult> judgeFrames(const Manifest& manifest, Frames drawn,
                                     const FrameRules& rules) {
    std::vector<CheckResult> all;
    std::set<std::string> charged;
    for (const Frame& frame : manifest.frames) {
        all.push_back(checkOf(manifest, frame));
        FrameJudge(manifest, frame, rules.at(frame.id), charged)
            .judge(std::move(drawn.byId[frame.id]), all.back());
    }
    return all;
}

}  // namespace grader
