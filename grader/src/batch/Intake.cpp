#include "batch/Intake.h"

#include <algorithm>
#include <optional>

#include "Error.h"

namespace grader {

namespace {

constexpr const char* kEndings[] = {".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2"};

/// The name without an archive's ending; nothing when it is no archive's name.
std::optional<std::string> stemOfArchive(const std::string& name) {
    for (const std::string ending : kEndings)
        if (name.ends_with(ending) && name.size() > ending.size())
            return name.substr(0, name.size() - ending.size());
    return std::nullopt;
}

bool isPlain(const fs::directory_entry& entry) {
    return entry.symlink_status().type() == fs::file_type::regular;
}

/// The archive that a student's folder stands for.
std::optional<fs::path> archiveInside(const fs::path& folder, const Manifest& manifest,
                                      const std::vector<std::string>& known) {
    std::optional<fs::path> archive;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const auto isOne = [&](const std::string& each) { return each == name; };
        if (std::any_of(manifest.submit.begin(), manifest.submit.end(), isOne) ||
            std::any_of(known.begin(), known.end(), isOne))
            return std::nullopt;
        if (!isPlain(entry) || !stemOfArchive(name))
            continue;
        if (archive)
            return std::nullopt;
        archive = entry.path();
    }
    return archive;
}

}  // namespace

Intake takeIn(const fs::path& submissions, const Manifest& manifest,
              const std::vector<std::string>& knownAssignments) {
    if (!fs::is_directory(submissions))
        throw Error(
            "{}: there is no such folder; expected one with a folder or an archive for "
            "each student",
            submissions.string());
    Intake intake;
    for (const auto& entry : fs::directory_iterator(submissions)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("."))
            continue;
        if (entry.symlink_status().type() == fs::file_type::directory) {
            const auto inside = archiveInside(entry.path(), manifest, knownAssignments);
            intake.entrants.push_back({name, inside.value_or(entry.path()), inside.has_value()});
        } else if (const auto stem = isPlain(entry) ? stemOfArchive(name) : std::nullopt) {
            intake.entrants.push_back({*stem, entry.path(), true});
        } else {
            intake.ignored.push_back(name + ": neither a folder nor an archive");
        }
    }
    const auto byName = [](const Entrant& a, const Entrant& b) { return a.name < b.name; };
    std::sort(intake.entrants.begin(), intake.entrants.end(), byName);
    std::sort(intake.ignored.begin(), intake.ignored.end());
    for (std::size_t i = 1; i < intake.entrants.size(); ++i)
        if (intake.entrants[i].name == intake.entrants[i - 1].name)
            throw Error("{} is there twice, as {} and as {}: take one away",
                        intake.entrants[i].name, intake.entrants[i - 1].path.filename().string(),
                        intake.entrants[i].path.filename().string());
    if (intake.entrants.empty())
        throw Error("{} holds no submission: expected a folder or an archive for each student",
                    submissions.string());
    return intake;
}

}  // namespace grader
