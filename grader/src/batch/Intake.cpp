#include "batch/Intake.h"

#include <algorithm>
#include <optional>

#include "Collect.h"
#include "Error.h"
#include "batch/Csv.h"
#include "batch/Platforms.h"
#include "report/PlainText.h"

namespace grader {

namespace {

constexpr const char* kEndings[] = {".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2"};

bool isPlain(const fs::path& path) {
    return typeOf(path) == fs::file_type::regular;
}

/// The archive that a student's folder stands for.
std::optional<fs::path> archiveInside(const fs::path& folder, const Manifest& manifest,
                                      const std::vector<std::string>& known) {
    const auto listed = handedIn(manifest);
    std::optional<fs::path> archive;
    for (const fs::path& entry : entriesOf(folder)) {
        const std::string name = entry.filename().string();
        if (hasFileNamed(listed, name) ||
            std::find(known.begin(), known.end(), name) != known.end())
            return std::nullopt;
        if (!isPlain(entry) || !stemOfArchive(name))
            continue;
        if (archive)
            return std::nullopt;
        archive = entry;
    }
    return archive;
}

/// Whether a file can be nothing but the one that the assignment wants.
bool isTheOnlyFile(const fs::path& file, const Manifest& manifest) {
    return manifest.submit.size() == 1 &&
           file.extension() == fs::path(manifest.submit.front()).extension();
}

Intake takeInPlain(const fs::path& submissions, const Manifest& manifest,
                   const std::vector<std::string>& known) {
    Intake intake;
    for (const fs::path& entry : entriesOf(submissions)) {
        const std::string name = entry.filename().string();
        if (name.starts_with("."))
            continue;
        if (typeOf(entry) == fs::file_type::directory)
            intake.entrants.push_back(entrantOf(name, entry, manifest, known));
        else if (const auto stem = isPlain(entry) ? stemOfArchive(name) : std::nullopt)
            intake.entrants.push_back({*stem, entry, EntrantKind::archive});
        else if (isPlain(entry) && isTheOnlyFile(entry, manifest))
            intake.entrants.push_back({entry.stem().string(),
                                       submissions,
                                       EntrantKind::looseFiles,
                                       {{manifest.submit.front(), entry}}});
        else
            intake.ignored.push_back(name + ": neither a folder nor an archive");
    }
    return intake;
}

}  // namespace

std::optional<std::string> stemOfArchive(const std::string& name) {
    for (const std::string ending : kEndings)
        if (name.ends_with(ending) && name.size() > ending.size())
            return name.substr(0, name.size() - ending.size());
    return std::nullopt;
}

Entrant entrantOf(const std::string& name, const fs::path& folder, const Manifest& manifest,
                  const std::vector<std::string>& known) {
    if (const auto repository = repositoryIn(folder))
        return {name, *repository, EntrantKind::clone};
    if (const auto archive = archiveInside(folder, manifest, known))
        return {name, *archive, EntrantKind::archive};
    return {name, folder, EntrantKind::folder};
}

Unpacked layOut(const Toolchain& tools, const Sandbox& sandbox, const Job& job,
                const Entrant& entrant, const std::vector<std::string>& known) {
    switch (entrant.kind) {
        case EntrantKind::archive:
            return unpackArchive(tools, sandbox, job, entrant.path, known);
        case EntrantKind::clone:
            return unpackClone(tools, sandbox, job, entrant.path, known);
        case EntrantKind::looseFiles: {
            const fs::path folder = job.work.path() / "submission";
            makeClosedFolder(folder);
            for (const LooseFile& each : entrant.files) {
                fs::create_directories((folder / each.name).parent_path());
                std::error_code failed;
                fs::copy_file(each.path, folder / each.name, failed);
                if (failed == std::errc::permission_denied)
                    return {{}, kUnreadable, ""};
                if (failed)
                    throw Error("{} cannot be read: {}", each.path.string(), failed.message());
            }
            return {folder, "", ""};
        }
        case EntrantKind::folder:
            break;
    }
    return {entrant.path, "", ""};
}

Intake takeIn(const fs::path& submissions, const Manifest& manifest,
              const std::vector<std::string>& known) {
    if (!fs::is_directory(submissions))
        throw Error(
            "{}: there is no such folder; expected one with a folder or an archive for "
            "each student",
            submissions.string());
    auto exported = takeInExport(submissions, manifest, known);
    Intake intake = exported ? std::move(*exported) : takeInPlain(submissions, manifest, known);
    const auto byName = [](const Entrant& a, const Entrant& b) { return a.name < b.name; };
    std::sort(intake.entrants.begin(), intake.entrants.end(), byName);
    std::sort(intake.ignored.begin(), intake.ignored.end());
    const auto placeOf = [&](const Entrant& each) {
        const fs::path& path = each.files.empty() ? each.path : each.files.front().path;
        return harmless(path.lexically_relative(submissions).string());
    };
    for (std::size_t i = 1; i < intake.entrants.size(); ++i)
        if (intake.entrants[i].name == intake.entrants[i - 1].name)
            throw Error("{} is there twice, as {} and as {}: take one away",
                        harmless(intake.entrants[i].name), placeOf(intake.entrants[i - 1]),
                        placeOf(intake.entrants[i]));
    if (intake.entrants.empty())
        throw Error("{} holds no submission: expected a folder or an archive for each student",
                    submissions.string());
    return intake;
}

void addTimes(Intake& intake, const fs::path& file) {
    const CsvTable table = CsvTable::read(file);
    const std::size_t submission = table.needColumn("submission"),
                      submitted = table.needColumn("submitted");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string name = table.cell(row, submission);
        const auto entrant = std::find_if(intake.entrants.begin(), intake.entrants.end(),
                                          [&](const Entrant& each) { return each.name == name; });
        if (entrant == intake.entrants.end())
            throw Error("{}: there is no submission \"{}\"", table.place(row), name);
        entrant->submitted = parseMoment(table.cell(row, submitted), table.place(row));
        if (const std::string student = table.cell(row, "student"); !student.empty())
            entrant->owners = {{student, "", ""}};
    }
}

}  // namespace grader
