#include "recognise/Recognise.h"

#include <fmt/format.h>

#include <algorithm>

#include "recognise/UsualSlips.h"

namespace grader {

namespace {

constexpr double kMuchNearer = 0.25;  // of the distance to the reference
constexpr double kNear = 3.0;         // mean difference of a channel, of 255
constexpr std::size_t kMostTold = 3;

const Evidence* find(const Answers& answers, const std::string& key) {
    const auto found = answers.find(key);
    return found == answers.end() ? nullptr : &found->second;
}

bool isLost(const CheckResult& check) {
    switch (check.status) {
        case Status::pass:
        case Status::notImplemented:
        case Status::skipped:
        case Status::pending:
        case Status::buildError:
        case Status::graderError:
            return false;
        default:
            return true;
    }
}

enum class Fit { contradicts, silent, explains };

/// Whether the answers of the student's code are those of the mistake.
Fit fitOfAnswers(const Signatures& known, const Signature& mistake, const Answers& got) {
    Fit fit = Fit::silent;
    for (const auto& [key, answer] : got) {
        const Evidence* right = find(known.right, key);
        const Evidence* expected = find(mistake.answers, key);
        if (answer.outcome == "absent" || answer.type == "large" || (!expected && !right))
            continue;  // a function that the submission lacks; an input that nobody else was asked
        if (!agree(answer, expected ? *expected : *right))
            return Fit::contradicts;
        if (expected && (!right || !agree(answer, *right)))
            fit = Fit::explains;
    }
    return fit;
}

/// Whether every lost frame looks like the mistake's.
Fit fitOfFrames(const Signature& mistake, const std::vector<CheckResult>& checks) {
    Fit fit = Fit::silent;
    for (const CheckResult& check : checks) {
        if (!check.pictures || !isLost(check))
            continue;
        const auto frame = mistake.frames.find(check.id);
        if (frame == mistake.frames.end())
            return Fit::contradicts;
        const Thumbnail mine = thumbnailOf(check.pictures->submission);
        const double toMistake = distance(mine, frame->second);
        const double toReference = distance(mine, thumbnailOf(check.pictures->reference));
        if (toMistake > kNear || toMistake > kMuchNearer * toReference)
            return Fit::contradicts;
        fit = Fit::explains;
    }
    return fit;
}

/// Whether their entries say one and the same thing that they have in common.
bool shareTheirCommon(const std::vector<const Signature*>& mistakes) {
    const std::string& common = mistakes.front()->common;
    return !common.empty() && std::all_of(mistakes.begin(), mistakes.end(),
                                          [&](const auto* each) { return each->common == common; });
}

Recognised together(const std::vector<const Signature*>& mistakes) {
    Recognised recognised;
    std::vector<std::string> said;
    for (const Signature* each : mistakes) {
        recognised.mistakes.push_back(each->mistake);
        if (std::find(said.begin(), said.end(), each->says) == said.end())
            said.push_back(each->says);
        if (recognised.section.empty())
            recognised.section = each->section;
        else if (recognised.section != each->section)
            recognised.section += ", " + each->section;
    }
    if (said.size() == 1)
        recognised.says = said.front();
    else if (shareTheirCommon(mistakes))
        recognised.says = mistakes.front()->common;
    else
        recognised.says =
            fmt::format("What came out fits more than one slip. {}", fmt::join(said, " Or: "));
    return recognised;
}

/// The section of the notes that most mistakes of a task point to.
std::string sectionOf(const Signatures& known, const std::string& task) {
    std::map<std::string, int> count;
    for (const Signature& each : known.mistakes)
        if (each.region == task)
            ++count[each.section];
    const auto most =
        std::max_element(count.begin(), count.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == count.end() ? "" : most->first;
}

std::optional<Recognised> recogniseSlip(const Signatures& known, const std::string& task,
                                        const Answers& got) {
    std::vector<AnswerPair> pairs;
    for (const auto& [key, answer] : got)
        if (const Evidence* right = find(known.right, key))
            pairs.push_back({*right, answer});
    if (const auto says = usualSlip(pairs))
        return Recognised{{}, *says, sectionOf(known, task)};
    return std::nullopt;
}

}  // namespace

std::optional<Recognised> recognise(const Signatures& known, const std::string& task,
                                    const std::vector<CheckResult>& checks) {
    if (std::none_of(checks.begin(), checks.end(), isLost))
        return std::nullopt;
    const Answers got = answersOf(checks);
    std::vector<const Signature*> byAnswers, byFrames;
    for (const Signature& mistake : known.mistakes) {
        if (!mistake.loses.contains(task))
            continue;
        const Fit fit = fitOfAnswers(known, mistake, got);
        if (fit == Fit::explains)
            byAnswers.push_back(&mistake);
        else if (fit == Fit::silent && fitOfFrames(mistake, checks) == Fit::explains)
            byFrames.push_back(&mistake);
    }
    const auto& candidates = byAnswers.empty() ? byFrames : byAnswers;
    if (!candidates.empty())
        return candidates.size() <= kMostTold || shareTheirCommon(candidates)
                   ? std::optional(together(candidates))
                   : std::nullopt;
    return recogniseSlip(known, task, got);
}

}  // namespace grader
