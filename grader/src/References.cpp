#include "References.h"

#include <algorithm>

#include "Error.h"
#include "Grade.h"
#include "ImageModule.h"
#include "Mistakes.h"

namespace grader {

namespace {

/// The pictures of all features that are drawn without, grouped by mistake: each is built once.
void drawAblated(const Grader& grader, const Manifest& manifest, std::uint64_t seed,
                 Pictures& pictures) {
    std::map<std::string, std::map<std::string, const Frame*>> wanted;  // mistake, name → frame
    for (const Frame& frame : manifest.frames)
        for (const Feature& feature : frame.features)
            wanted[feature.without][ablatedName(frame, feature)] = &frame;
    if (wanted.empty())
        return;
    const auto mistakes = readMistakes(grader.tools().root / "solutions" / manifest.id);
    for (const auto& [id, names] : wanted) {
        const auto mistake = std::find_if(mistakes.begin(), mistakes.end(),
                                          [&](const Mistake& each) { return each.id == id; });
        if (mistake == mistakes.end())
            throw Error(
                "{}: a feature is \"without\" \"{}\", which is no mistake in {}",
                (manifest.folder / "assignment.json").string(), id,
                (grader.tools().root / "solutions" / manifest.id / "mistakes.json").string());
        auto drawn = grader.draw(
            manifest, stageWith(grader.stageOf(manifest, "solutions"), *mistake, mistake->body),
            seed);
        for (const auto& [name, frame] : names)
            pictures[name] = drawn.at(frame->id);
    }
}

}  // namespace

std::string referenceName(const Frame& frame) {
    return frame.id + ".png";
}
std::string starterName(const Frame& frame) {
    return frame.id + ".starter.png";
}
std::string ablatedName(const Frame& frame, const Feature& feature) {
    return frame.id + "." + feature.id + ".png";
}

std::vector<std::string> referenceNames(const Manifest& manifest) {
    std::vector<std::string> names;
    for (const Frame& frame : manifest.frames) {
        names.insert(names.end(), {referenceName(frame), starterName(frame)});
        for (const Feature& feature : frame.features)
            names.push_back(ablatedName(frame, feature));
    }
    return names;
}

fs::path referenceFolder(const Toolchain& tools, const std::string& assignment) {
    return tools.root / "reference_images" / assignment;
}
fs::path signaturesFile(const Toolchain& tools, const std::string& assignment) {
    return referenceFolder(tools, assignment) / "signatures.cbor";
}

Pictures loadReferences(const Toolchain& tools, const Manifest& manifest) {
    Pictures pictures;
    for (const Frame& frame : manifest.frames) {
        std::vector<std::string> names{referenceName(frame), starterName(frame)};
        for (const Feature& feature : frame.features)
            names.push_back(ablatedName(frame, feature));
        for (const std::string& name : names) {
            const fs::path file = referenceFolder(tools, manifest.id) / name;
            if (!fs::exists(file))
                throw Error("{} is missing: run ./grade update-references {}", file.string(),
                            manifest.id);
            Picture picture = readPictureCached(file, tools.cache / "pictures");
            if (picture.width != frame.width || picture.height != frame.height)
                throw Error(
                    "{}: expected {} x {} pixels, found {} x {}: run ./grade "
                    "update-references {}",
                    file.string(), frame.width, frame.height, picture.width, picture.height,
                    manifest.id);
            pictures[name] = std::move(picture);
        }
    }
    return pictures;
}

bool canDrawReferences(const fs::path& root, const std::string& assignment) {
    return fs::exists(root / "solutions" / assignment / "mistakes.json");
}

Pictures drawReferences(const Grader& grader, const Manifest& manifest, std::uint64_t seed) {
    if (!canDrawReferences(grader.tools().root, manifest.id))
        throw Error(
            "seed {} needs solutions/{} with its mistakes, which are not here: only seed {} has "
            "stored references",
            seed, manifest.id, kPublishedSeed);
    Pictures pictures;
    auto solved = grader.draw(manifest, grader.stageOf(manifest, "solutions"), seed);
    auto starters = grader.draw(manifest, grader.stageOf(manifest, "assignments"), seed);
    for (const Frame& frame : manifest.frames) {
        pictures[referenceName(frame)] = std::move(solved.at(frame.id));
        pictures[starterName(frame)] = std::move(starters.at(frame.id));
    }
    drawAblated(grader, manifest, seed, pictures);
    return pictures;
}

FrameRules rulesOf(const Manifest& manifest, Pictures pictures) {
    FrameRules rules;
    for (const Frame& frame : manifest.frames) {
        FrameTruth truth{std::move(pictures.at(referenceName(frame))),
                         {std::move(pictures.at(starterName(frame)))},
                         {},
                         frame.tolerance};
        for (const Feature& feature : frame.features)
            truth.features.push_back(
                {feature.id, feature.title, std::move(pictures.at(ablatedName(frame, feature)))});
        rules.emplace(frame.id, std::move(truth));
    }
    return rules;
}

Signatures makeSignatures(const Grader& grader, const Manifest& manifest) {
    const Stage solution = grader.stageOf(manifest, "solutions");
    Signatures signatures;
    signatures.right = answersOf(grader.gradeStage(manifest, solution, kPublishedSeed).checks);
    for (const Mistake& mistake : readMistakes(grader.tools().root / "solutions" / manifest.id)) {
        const auto graded =
            grader.gradeStage(manifest, stageWith(solution, mistake, mistake.body), kPublishedSeed);
        signatures.mistakes.push_back(signatureOf(mistake, signatures.right, graded.checks));
    }
    return signatures;
}

}  // namespace grader
