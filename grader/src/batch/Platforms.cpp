#include "batch/Platforms.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <regex>

#include "Collect.h"
#include "Error.h"

namespace grader {

namespace {

constexpr const char* kGradescopeMetadata = "submission_metadata.yml";

std::vector<fs::directory_entry> visibleEntries(const fs::path& folder) {
    std::vector<fs::directory_entry> entries;
    for (const auto& entry : fs::directory_iterator(folder))
        if (!entry.path().filename().string().starts_with("."))
            entries.push_back(entry);
    std::sort(entries.begin(), entries.end());
    return entries;
}

using Listed = std::map<std::string, fs::path>;  // as handedIn() has them

/// "Camera-1.cpp" → "Camera.cpp", where that is a file of the assignment.
std::string withoutRepeat(const std::string& name, const Listed& listed) {
    static const std::regex kRepeat(R"((.+)-\d+(\.[^.]+))");
    std::smatch part;
    if (!std::regex_match(name, part, kRepeat) || hasFileNamed(listed, name))
        return name;
    const std::string plain = part[1].str() + part[2].str();
    return hasFileNamed(listed, plain) ? plain : name;
}

/// Files of one student that lie among others': one archive stands for itself.
Entrant entrantOfFiles(std::string name, std::vector<LooseFile> files, const Listed& listed) {
    const bool anyListed = std::any_of(files.begin(), files.end(), [&](const LooseFile& each) {
        return hasFileNamed(listed, each.name);
    });
    const auto archives = std::count_if(files.begin(), files.end(), [](const LooseFile& each) {
        return stemOfArchive(each.name).has_value();
    });
    if (!anyListed && archives == 1) {
        const auto archive = std::find_if(files.begin(), files.end(), [](const LooseFile& each) {
            return stemOfArchive(each.name).has_value();
        });
        return {std::move(name), archive->path, EntrantKind::archive};
    }
    Entrant entrant{std::move(name), files.front().path.parent_path(), EntrantKind::looseFiles};
    entrant.files = std::move(files);
    return entrant;
}

struct CanvasFile {
    long long attachment = 0;
    LooseFile file;
};

Intake takeInCanvas(const std::vector<fs::directory_entry>& entries, const std::regex& form,
                    const Listed& listed) {
    Intake intake;
    std::map<std::string, std::map<std::string, CanvasFile>> students;  // name → file name → newest
    std::map<std::string, Entrant> about;
    for (const auto& entry : entries) {
        const std::string name = entry.path().filename().string();
        std::smatch part;
        if (!std::regex_match(name, part, form) ||
            entry.symlink_status().type() != fs::file_type::regular) {
            intake.ignored.push_back(name + ": not named as Canvas names submissions");
            continue;
        }
        const std::string student = part[1].str() + "_" + part[3].str();
        const CanvasFile file{std::stoll(part[4].str()),
                              {withoutRepeat(part[5].str(), listed), entry.path()}};
        CanvasFile& newest = students[student][file.file.name];
        if (newest.file.name.empty() || newest.attachment < file.attachment)
            newest = file;
        about[student].owners = {{part[3].str(), "", ""}};
        about[student].late = about[student].late || part[2].matched;
    }
    for (auto& [student, files] : students) {
        std::vector<LooseFile> loose;
        for (auto& [name, each] : files)
            loose.push_back(std::move(each.file));
        Entrant entrant = entrantOfFiles(student, std::move(loose), listed);
        entrant.owners = about[student].owners;
        entrant.late = about[student].late;
        intake.entrants.push_back(std::move(entrant));
    }
    return intake;
}

Intake takeInMoodle(const std::vector<fs::directory_entry>& entries, const std::regex& form,
                    const Manifest& manifest, const std::vector<std::string>& known) {
    Intake intake;
    std::map<std::string, std::vector<LooseFile>> loose;
    std::map<std::string, Owner> owners;
    for (const auto& entry : entries) {
        const std::string name = entry.path().filename().string();
        std::smatch part;
        if (!std::regex_match(name, part, form)) {
            intake.ignored.push_back(name + ": not named as Moodle names submissions");
            continue;
        }
        const std::string student = part[1].str() + "_" + part[2].str();
        owners[student] = {part[2].str(), part[1].str(), ""};
        const auto type = entry.symlink_status().type();
        if (part[3] == "onlinetext")
            intake.ignored.push_back(name + ": a text, not files");
        else if (type == fs::file_type::directory)
            intake.entrants.push_back(entrantOf(student, entry.path(), manifest, known));
        else if (type == fs::file_type::regular && part[4].length() > 0)
            loose[student].push_back({part[4].str(), entry.path()});
        else
            intake.ignored.push_back(name + ": neither a folder nor a file");
    }
    const Listed listed = handedIn(manifest);
    for (auto& [student, files] : loose)
        intake.entrants.push_back(entrantOfFiles(student, std::move(files), listed));
    for (Entrant& each : intake.entrants)
        each.owners = {owners.at(each.name)};
    return intake;
}

/// A text of Gradescope's metadata, whose keys are written as Ruby's symbols.
std::string textOf(const YAML::Node& node, const std::string& key) {
    const YAML::Node value = node[":" + key];
    return value && value.IsScalar() ? value.as<std::string>() : "";
}

Intake takeInGradescope(const fs::path& submissions,
                        const std::vector<fs::directory_entry>& entries, const Manifest& manifest,
                        const std::vector<std::string>& known) {
    const std::string file = (submissions / kGradescopeMetadata).string();
    Intake intake;
    try {
        const YAML::Node metadata = YAML::LoadFile(file);
        for (const auto& entry : entries) {
            const std::string name = entry.path().filename().string();
            if (name == kGradescopeMetadata)
                continue;
            const YAML::Node about = metadata[name];
            if (!about || entry.symlink_status().type() != fs::file_type::directory) {
                intake.ignored.push_back(name + ": not in " + kGradescopeMetadata);
                continue;
            }
            Entrant entrant = entrantOf(name, entry.path(), manifest, known);
            for (const YAML::Node& each : about[":submitters"])
                entrant.owners.push_back(
                    {textOf(each, "sid"), textOf(each, "name"), textOf(each, "email")});
            if (const std::string time = textOf(about, "created_at"); !time.empty())
                entrant.submitted = parseMoment(time, file + ": " + name);
            intake.entrants.push_back(std::move(entrant));
        }
    } catch (const YAML::Exception& error) {
        throw Error("{} is not what Gradescope writes: {}", file, error.what());
    }
    return intake;
}

}  // namespace

std::optional<Intake> takeInExport(const fs::path& submissions, const Manifest& manifest,
                                   const std::vector<std::string>& known) {
    static const std::regex kCanvas(R"(([^_]+)_(LATE_)?(\d{1,18})_(\d{1,18})_(.+))");
    static const std::regex kMoodle(R"((.+?)_(\d+)_assignsubmission_(file|onlinetext)_?(.*))");
    const auto entries = visibleEntries(submissions);
    if (fs::is_regular_file(fs::symlink_status(submissions / kGradescopeMetadata)))
        return takeInGradescope(submissions, entries, manifest, known);
    const auto mostAre = [&](const std::regex& form) {
        const auto named = std::count_if(entries.begin(), entries.end(), [&](const auto& entry) {
            return std::regex_match(entry.path().filename().string(), form);
        });
        return named > 0 && 2 * static_cast<std::size_t>(named) >= entries.size();
    };
    if (mostAre(kMoodle))
        return takeInMoodle(entries, kMoodle, manifest, known);
    if (mostAre(kCanvas))
        return takeInCanvas(entries, kCanvas, handedIn(manifest));
    return std::nullopt;
}

}  // namespace grader
