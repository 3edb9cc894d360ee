#include "course/CheckReferences.h"

#include <fmt/format.h>

#include <algorithm>

#include "References.h"

namespace grader {

namespace {

std::string updateCommand(const Manifest& manifest) {
    return "./grade update-references " + manifest.id;
}

/// The frame that a picture belongs to: its name starts with the frame's id.
const Frame* frameOf(const Manifest& manifest, const std::string& pictureName) {
    const std::string id = pictureName.substr(0, pictureName.find('.'));
    return &*std::find_if(manifest.frames.begin(), manifest.frames.end(),
                          [&](const Frame& frame) { return frame.id == id; });
}

void checkPictures(const Grader& grader, const Manifest& manifest, Findings& findings) {
    const Pictures stored = loadReferences(grader.tools(), manifest);
    for (const auto& [name, picture] : drawReferences(grader, manifest, kPublishedSeed)) {
        const double outliers = outlierShare(picture, stored.at(name));
        const Frame* frame = frameOf(manifest, name);
        if (outliers > frame->tolerance)  // another driver may have drawn the stored one
            findings.add(fmt::format("{} is not what is drawn today: {:.3f} % of the pixels differ",
                                     (referenceFolder(grader.tools(), manifest.id) / name).string(),
                                     100 * outliers),
                         updateCommand(manifest));
    }
}

}  // namespace

void checkReferences(const Grader& grader, const Manifest& manifest, Findings& findings) {
    checkPictures(grader, manifest, findings);
    for (const auto& [id, rule] : grader.rules(manifest, kPublishedSeed)) {
        const FrameTruth& truth = rule.truth();
        for (const FeatureScore& feature : rule.score(truth.reference).features)
            if (!feature.measurable)
                findings.add(fmt::format("frame {}: feature {} cannot be measured: a picture that "
                                         "shows nothing learnt already has it",
                                         id, feature.id),
                             "choose another camera or another \"without\"");
        std::vector<Picture> blanks = truth.baselines;
        blanks.push_back(flatPicture(truth.reference, {0, 0, 0}));
        blanks.push_back(flatPicture(truth.reference, meanColour(truth.reference)));
        for (const Picture& blank : blanks) {
            const FrameScore score = rule.score(blank);
            double earned = truth.features.empty() ? score.score : 0;
            for (const FeatureScore& feature : score.features)
                earned += feature.score;
            if (earned > 0)
                findings.add(
                    fmt::format("frame {}: a picture that shows nothing learnt earns {:.3f}", id,
                                earned),
                    "choose a camera from which the starter's picture is another");
        }
    }
}

void checkSignatures(const Grader& grader, const Manifest& manifest, const Signatures& today,
                     Findings& findings) {
    const auto changed = differing(grader.signatures(manifest), today);
    if (!changed.empty())
        findings.add(fmt::format("{} is not what mistakes show today: {}",
                                 signaturesFile(grader.tools(), manifest.id).string(),
                                 fmt::join(changed, ", ")),
                     updateCommand(manifest));
}

}  // namespace grader
