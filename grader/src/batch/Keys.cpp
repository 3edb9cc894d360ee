#include "batch/Keys.h"

#include <algorithm>

#include "Archive.h"
#include "BuildId.h"
#include "Error.h"
#include "Fields.h"
#include "Mistakes.h"

namespace grader {

namespace {

/// What is larger than may be taken is told by its size alone; what cannot be read is refused
/// later.
std::string hashUpTo(std::uintmax_t most, const fs::path& file) {
    std::error_code none;
    const auto size = fs::file_size(file, none);
    if (!none && size > most)
        return fmt::format("{} bytes", size);
    try {
        return sha256(readFile(file));
    } catch (const Error&) {
        return "unreadable";
    }
}

std::string hashOfFolder(const fs::path& folder) {
    std::string text;
    std::vector<fs::path> files;
    std::error_code unreadable;
    for (fs::recursive_directory_iterator each(folder, unreadable), end; !unreadable && each != end;
         each.increment(unreadable))
        if (typeOf(each->path()) == fs::file_type::regular)
            files.push_back(each->path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
        text += file.lexically_relative(folder).string() + "\n" + hashUpTo(kLargestArchive, file) +
                "\n";
    return sha256(text);
}

/// Which commit a repository's HEAD names, however it does.
std::string hashOfReferences(const fs::path& repository) {
    std::string text;
    for (const char* each : {"HEAD", "packed-refs"})
        if (typeOf(repository / each) == fs::file_type::regular)
            text += hashUpTo(kLargestArchive, repository / each) + "\n";
    return sha256(text + hashOfFolder(repository / "refs"));
}

std::string textOf(const StagedFile& file) {
    return file.name + " " + file.origin + " " + sha256(file.content) + "\n";
}

std::string textOf(const Stage& stage) {
    std::string text;
    for (const StagedFile& file : stage.files)
        text += textOf(file);
    return text;
}

/// Leaves of the manifest what decides results: whether a thing has points does, how many does not.
/// A feature's title becomes part of what is said about a picture.
void keepDeciding(Json& json, bool isFeature = false) {
    if (json.is_object()) {
        for (const char* each : {"summary", "hint", "why", "starter_passes"})
            json.erase(each);
        if (!isFeature)
            json.erase("title");
        if (const auto points = json.find("points"); points != json.end())
            *points = points->is_number() && points->get<double>() > 0;
        for (auto& [name, each] : json.items())
            keepDeciding(each, name == "features");
    } else if (json.is_array()) {
        for (Json& each : json)
            keepDeciding(each, isFeature);
    }
}

std::string manifestOf(const Manifest& manifest) {
    return readFile(manifest.folder / "assignment.json");
}

std::string decidingOf(const Manifest& manifest) {
    Json json = Json::parse(manifestOf(manifest));
    keepDeciding(json);
    return json.dump() + "\n";
}

/// A secret seed draws what lacks a feature from a mistake.
std::string mistakesOfFeatures(const Toolchain& tools, const Manifest& manifest) {
    std::set<std::string> wanted;
    for (const Frame& frame : manifest.frames)
        for (const Feature& feature : frame.features)
            wanted.insert(feature.without);
    const fs::path solution = tools.root / "solutions" / manifest.id;
    std::string text;
    if (!wanted.empty() && fs::is_directory(solution))
        for (const Mistake& each : readMistakes(solution))
            if (wanted.contains(each.id))
                text += each.id + " " + each.file + " " + each.region + "\n" + each.body;
    return text;
}

/// Without the solution, whether a task of an earlier assignment holds is found out by grading it.
std::string neededAssignments(const Grader& grader, const Manifest& manifest) {
    const Toolchain& tools = grader.tools();
    std::set<std::string> needed;
    for (const Task& task : manifest.tasks)
        for (const std::string& need : task.needs)
            if (const auto slash = need.find('/'); slash != std::string::npos)
                needed.insert(need.substr(0, slash));
    std::string text;
    for (const std::string& id : needed)
        if (!fs::exists(tools.root / "solutions" / id)) {
            const Manifest other = loadAssignment(tools.root, id);
            text += id + " " + identityOf(tools.judge(id)) + "\n" + decidingOf(other) +
                    textOf(grader.stageOf(other, "assignments"));
        }
    return text;
}

std::string rendererOf(const Toolchain& tools, const Sandbox& sandbox) {
    try {
        const Job job;
        const auto graphics = Observer(tools, sandbox, {}).describeGraphics(job);
        return graphics.provider + " " + graphics.renderer + " " + graphics.version;
    } catch (const Error& error) {
        return error.what();
    }
}

/// What else lies in the submission's folder is named in the report.
std::string namesIn(const Submission& submission, const fs::path& folder) {
    std::string names;
    for (const fs::path& each : submission.entriesOf(folder))
        names += each.filename().string() + "\n";
    return names;
}

std::string textOf(const fs::path& root, const Manifest& manifest, const Entrant& entrant,
                   const std::vector<std::string>& known) {
    switch (entrant.kind) {
        case EntrantKind::archive:
            return "archive\n" + hashUpTo(kLargestArchive, entrant.path);
        case EntrantKind::clone:
            return "clone\n" + hashOfReferences(entrant.path);
        case EntrantKind::looseFiles: {
            std::string text;
            for (const LooseFile& each : entrant.files)
                text += each.name + " " + hashUpTo(kLargestFile, each.path) + "\n";
            return text;
        }
        case EntrantKind::folder:
            break;
    }
    const Submission submission = submissionIn(entrant.path, known);
    std::string text;
    for (const StagedFile& file : collect(root, manifest, submission).stage.files)
        if (file.role != Role::provided)
            text += textOf(file);
    return text + namesIn(submission, submission.folderFor(manifest.id));
}

}  // namespace

Key keyOfRules(const Grader& grader, const Sandbox& sandbox, const Manifest& manifest,
               std::uint64_t seed) {
    const Toolchain& tools = grader.tools();
    std::string text;
    for (const std::string& each :
         {identityOf("/proc/self/exe"), tools.kitFingerprint, tools.compilerVersion,
          fmt::format("{} {}", fmt::join(tools.compileFlags, " "), fmt::join(tools.linkFlags, " ")),
          tools.glmVersion, sandbox.name(), cpuModel(), rendererOf(tools, sandbox),
          std::to_string(seed), identityOf(tools.judge(manifest.id)), decidingOf(manifest),
          textOf(grader.stageOf(manifest, "assignments")),
          hashOfFolder(tools.root / "reference_images" / manifest.id),
          neededAssignments(grader, manifest)})
        text += each + "\n";
    for (const auto& [name, from] : manifest.inherits)
        if (const fs::path file = tools.root / "solutions" / from / name; fs::exists(file))
            text += name + " " + sha256(readFile(file)) + "\n";
    if (fs::is_directory(tools.root / "solutions" / manifest.id))
        text += textOf(grader.stageOf(manifest, "solutions")) + mistakesOfFeatures(tools, manifest);
    return {sha256(text), sha256(manifestOf(manifest))};
}

Key keyOf(const Key& rules, const fs::path& root, const Manifest& manifest, const Entrant& entrant,
          const std::vector<std::string>& known) {
    return {sha256(rules.deciding + textOf(root, manifest, entrant, known)), rules.wording};
}

}  // namespace grader
