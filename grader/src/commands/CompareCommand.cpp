#include "commands/CompareCommand.h"

#include <fmt/format.h>

#include <iostream>

#include "Error.h"
#include "ExitCode.h"
#include "Fields.h"
#include "ImageModule.h"
#include "compare/FrameScore.h"

namespace grader {

namespace {

struct Options {
    std::string submission, reference;
    std::vector<std::string> baselines, features;
    double tolerance = 0.0005;
    bool json = false;
};

/// A picture that the reference is compared with, and so has its size.
Picture readOfSize(const std::string& path, const Picture& reference) {
    Picture picture = readPicture(path);
    if (!picture.sameSizeAs(reference))
        throw Error("{}: expected {} x {} pixels as in the reference, found {} x {}", path,
                    reference.width, reference.height, picture.width, picture.height);
    return picture;
}

FrameTruth truthOf(const Options& options) {
    FrameTruth truth{readPicture(options.reference), {}, {}, options.tolerance};
    for (const std::string& path : options.baselines)
        truth.baselines.push_back(readOfSize(path, truth.reference));
    for (const std::string& text : options.features) {
        const auto at = text.find('=');
        if (at == std::string::npos || at == 0)
            throw Error("--feature {}: expected NAME=PICTURE, the reference without that feature",
                        text);
        const std::string name = text.substr(0, at);
        truth.features.push_back({name, name, readOfSize(text.substr(at + 1), truth.reference)});
    }
    return truth;
}

Json jsonOf(const Displacement& displacement) {
    return {{"x", displacement.x}, {"y", displacement.y}};
}

Json jsonOf(const FrameScore& score) {
    Json json = {{"format", 1},
                 {"score", score.score},
                 {"charge", score.fault ? kFaultCharge : 0.0},
                 {"outliers", score.outliers},
                 {"mean_error", score.meanError},
                 {"skill", score.skill},
                 {"boundary", score.boundary},
                 {"size_matches", score.sizeMatches},
                 {"sentence", score.sentence}};
    if (score.fault)
        json["fault"] = score.fault->id;
    if (score.displacement)
        json["displacement"] = jsonOf(*score.displacement);
    json["features"] = Json::array();
    for (const FeatureScore& each : score.features) {
        json["features"].push_back({{"id", each.id},
                                    {"score", each.score},
                                    {"measurable", each.measurable},
                                    {"pixels", each.pixels},
                                    {"sentence", each.sentence}});
        if (each.displacement)
            json["features"].back()["displacement"] = jsonOf(*each.displacement);
    }
    return json;
}

void print(const FrameScore& score) {
    std::cout << fmt::format("score    {:.3f}  {}\n", score.score, score.sentence);
    if (score.fault)
        std::cout << fmt::format("         of which {:.0f} % are charged for it, once\n",
                                 100 * kFaultCharge);
    std::cout << fmt::format(
        "         {:.3f} % of the pixels differ; mean error {:.4f}; skill {:.3f}; boundaries "
        "{:.3f}\n",
        100 * score.outliers, score.meanError, score.skill, score.boundary);
    for (const FeatureScore& each : score.features)
        std::cout << fmt::format("feature  {:.3f}  {}{}\n", each.score, each.id,
                                 !each.measurable
                                     ? ": cannot be measured, a picture without it shows it, too"
                                 : each.sentence.empty() ? ""
                                                         : ": " + each.sentence);
}

}  // namespace

void addCompareCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command = app.add_subcommand("compare", "score a picture as a frame is scored");
    command->add_option("submission", options.submission, "PNG, EXR or another picture")
        ->required();
    command->add_option("reference", options.reference, "the right picture")->required();
    command->add_option("--baseline", options.baselines,
                        "a picture that shows nothing learnt; may be said several times");
    command->add_option("--feature", options.features,
                        "NAME=PICTURE, the reference without that feature; may be said several "
                        "times");
    command->add_option("--tolerance", options.tolerance, "share of the pixels that may differ")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
    command->add_flag("--json", options.json, "print what RESULT.md describes");
    command->callback([&exitCode] {
        const FrameRule rule(truthOf(options));
        const FrameScore score = rule.score(readPicture(options.submission));
        if (options.json)
            std::cout << jsonOf(score).dump(2) << "\n";
        else
            print(score);
        const bool full = score.score >= 1 && !score.fault;
        exitCode = full ? kFullMarks : kSomethingLost;
    });
}

}  // namespace grader
