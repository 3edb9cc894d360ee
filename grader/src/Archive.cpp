#include "Archive.h"

#include <algorithm>
#include <optional>

#include "Error.h"
#include "Process.h"
#include "unpack/Unpack.h"

namespace grader {

namespace {

constexpr int kSeconds = 20;
constexpr int kMemoryMib = 512;
constexpr std::size_t kLargestArchive = unpack::Limits{}.bytes;
constexpr int kMostMib = kLargestArchive >> 20;

/// The only folder in `folder`, when there is nothing else but what operating systems leave.
std::optional<fs::path> onlyFolderIn(const fs::path& folder) {
    std::optional<fs::path> only;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name == "__MACOSX" || name == ".DS_Store")
            continue;
        if (only || !fs::is_directory(entry.symlink_status()))
            return std::nullopt;
        only = entry.path();
    }
    return only;
}

}  // namespace

Unpacked unpackArchive(const Toolchain& tools, const Sandbox& sandbox, const Job& job,
                       const fs::path& archive, const std::vector<std::string>& known) {
    Unpacked unpacked{job.work.path() / "unpacked", "", ""};
    std::error_code failed;
    if (fs::file_size(archive, failed) > kLargestArchive && !failed) {
        unpacked.refusal = fmt::format("it is larger than {} MiB", kMostMib);
        return unpacked;
    }
    const fs::path copy = job.work.path() / "archive" / "file";
    fs::create_directories(copy.parent_path());
    fs::create_directories(unpacked.folder);
    fs::copy_file(archive, copy, failed);
    if (failed)
        throw Error("{} cannot be read: {}", archive.string(), failed.message());
    shareWithSandbox(copy.parent_path(), job.user.id(), false);
    shareWithSandbox(unpacked.folder, job.user.id(), true);

    Confinement confinement;
    confinement.readable = {tools.kit, copy.parent_path()};
    confinement.writable = {unpacked.folder};
    confinement.workingFolder = unpacked.folder;
    confinement.user = job.user.id();
    confinement.limits.cpuSeconds = kSeconds;
    confinement.limits.memoryMib = kMemoryMib;
    confinement.limits.fileMib = kMostMib;
    const ProcessResult ran =
        run(sandbox.confine(confinement, {tools.unpack().string(), copy.string(), unpacked.folder}),
            3 * kSeconds);
    if (ran.timedOut || ran.signal != 0)
        unpacked.refusal = fmt::format("it could not be unpacked within {} s and {} MiB of memory",
                                       kSeconds, kMemoryMib);
    else if (ran.exitCode == 1)
        unpacked.refusal = ran.output.substr(0, ran.output.find('\n'));
    else if (ran.exitCode != 0)
        throw Error("{} cannot be unpacked: {}", archive.string(), ran.output);
    while (const auto only =
               unpacked.refusal.empty() ? onlyFolderIn(unpacked.folder) : std::nullopt) {
        const std::string name = only->filename().string();
        if (std::find(known.begin(), known.end(), name) != known.end())
            break;
        unpacked.folder = *only;
        unpacked.notice +=
            (unpacked.notice.empty() ? "taken out of the archive's folder " : "/") + name;
    }
    return unpacked;
}

}  // namespace grader
