#include "report/HtmlCheck.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/Html.h"
#include "report/Words.h"

namespace grader {

namespace {

std::string figure(const std::string& picture, const std::string& caption) {
    return "<figure>" + picture + "<figcaption>" + caption + "</figcaption></figure>\n";
}

/// The three pictures beside each other: what is seen without scripts and on paper, and what
/// report.js makes the viewer from. Without the reference, the submission's alone.
std::string picturesOf(const CheckResult& check, const fs::path& folder) {
    const auto file = [&](const char* name) { return folder / check.imagePaths.at(name); };
    const std::string yours =
        figure(pictureOf(file("submission"), "yours", "Your picture: " + check.title), "yours");
    if (!check.imagePaths.contains("reference"))
        return "<div class=\"pictures\">\n" + yours + "</div>\n";
    return "<div class=\"pictures\">\n" + yours +
           figure(pictureOf(file("reference"), "reference", "The reference: " + check.title),
                  "reference") +
           figure(pictureOf(file("difference"), "difference",
                            "Where your picture differs from the reference: " + check.title),
                  "difference (white: wrong)") +
           "</div>\n";
}

std::string numbersOf(const CheckResult& check) {
    if (check.maxPoints == 0)
        return "<p class=\"numbers\">Shown to look at; no points depend on it.</p>\n";
    const FrameScore& score = check.pictures->score;
    return fmt::format(
        "<p class=\"numbers\">{:.3f} % of the pixels differ; mean error {:.4f}; score {:.3f}</p>\n",
        100 * score.outliers, score.meanError, score.score);
}

std::string featureRow(const FeatureResult& feature, const fs::path& folder) {
    const bool full = feature.points >= feature.maxPoints;
    const Status status = full ? Status::pass : feature.points > 0 ? Status::partial : Status::fail;
    std::string mask;
    if (!feature.maskPath.empty())
        mask = pictureOf(folder / feature.maskPath, "mask", "Where it shows: " + feature.title);
    return fmt::format(
        "<li class=\"feature\"{}><p>{}<span class=\"title\">{}</span>"
        "<span class=\"points\">{}</span></p>{}<p class=\"message\">{}</p>{}</li>\n",
        mask.empty() ? "" : " tabindex=\"0\"", markOf(status), escaped(feature.title),
        scoreText(feature.points, feature.maxPoints), barOf(feature.points, feature.maxPoints),
        escaped(feature.message), mask);
}

std::string featuresOf(const CheckResult& check, const fs::path& folder) {
    std::string rows;
    for (const FeatureResult& each : check.features)
        if (each.points > 0 || !each.message.empty())  // else it was not looked at
            rows += featureRow(each, folder);
    return rows.empty() ? "" : "<ul class=\"features\">\n" + rows + "</ul>\n";
}

std::string frameOf(const CheckResult& check, const fs::path& folder) {
    const bool drawn = check.pictures && !check.imagePaths.empty();
    const std::string features = featuresOf(check, folder);
    if (!drawn && features.empty())
        return "";
    return "<div class=\"frame\">\n" + (drawn ? picturesOf(check, folder) : "") + features +
           (drawn ? numbersOf(check) : "") + "</div>\n";
}

bool isFinite(const std::vector<std::vector<double>>& matrix) {
    return std::all_of(matrix.begin(), matrix.end(), [](const std::vector<double>& row) {
        return std::all_of(row.begin(), row.end(), [](double each) { return std::isfinite(each); });
    });
}

/// Whether a message says only what the matrices show better. They cannot tell inf from nan.
bool isShownByMatrices(const CheckResult& check) {
    const std::string got = ", got ";
    const auto at = check.message.find(got);
    return check.comparison && at != std::string::npos && isFinite(check.comparison->got) &&
           check.message.starts_with(check.comparison->what + ": expected ") &&
           check.message.find_first_of("([", at) == at + got.size();
}

std::string messageOf(const CheckResult& check) {
    if (check.message.empty() || isShownByMatrices(check))
        return "";
    return fmt::format("<p class=\"message{}\">{}</p>\n",
                       check.status == Status::buildError ? " log" : "", escaped(check.message));
}

bool wantsHint(const CheckResult& check) {
    return !check.hint.empty() && check.status != Status::notImplemented &&
           check.status != Status::skipped && check.status != Status::buildError;
}

std::string summaryOf(const CheckResult& check) {
    return fmt::format(
        "<summary>{}<span class=\"title\">{}</span><span class=\"points\">{}</span></summary>\n",
        markOf(check.status), escaped(check.title),
        check.maxPoints > 0 ? scoreText(check.points, check.maxPoints) : "");
}

}  // namespace

std::string lostCheck(const CheckResult& check, const fs::path& folder, bool open, bool withHint) {
    return fmt::format("<details class=\"check {}\"{}>{}<div class=\"inside\">",
                       judge::toString(check.status), open ? " open" : "", summaryOf(check)) +
           messageOf(check) + (check.comparison ? comparisonOf(*check.comparison) : "") +
           (withHint && wantsHint(check)
                ? "<p class=\"hint\">Hint: " + escaped(check.hint) + "</p>\n"
                : "") +
           frameOf(check, folder) + "</div></details>\n";
}

std::string fullFrame(const CheckResult& check, const fs::path& folder) {
    return "<details class=\"check full pass\">" + summaryOf(check) + "<div class=\"inside\">" +
           frameOf(check, folder) + "</div></details>\n";
}

}  // namespace grader
