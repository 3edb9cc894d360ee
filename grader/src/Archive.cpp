#include "Archive.h"

#include <algorithm>
#include <csignal>
#include <optional>

#include "Error.h"
#include "Process.h"

namespace grader {

namespace {

constexpr int kSeconds = 20;  // of processor time
constexpr int kClockSeconds = 3 * kSeconds;
constexpr int kMemoryMib = 512;
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

Confinement confinementOf(const Job& job) {
    Confinement confinement;
    confinement.user = job.user.id();
    confinement.limits.cpuSeconds = kSeconds;
    confinement.limits.memoryMib = memoryForOwn(kMemoryMib);
    confinement.limits.fileMib = kMostMib;
    return confinement;
}

/// Why a program that read the submission's bytes was ended, where that is their doing; empty
/// otherwise.
std::string theirDoing(const ProcessResult& ran) {
    const auto by = [&](std::initializer_list<int> signals) {
        return std::any_of(signals.begin(), signals.end(),
                           [&](int signal) { return ran.endedBy(signal); });
    };
    if (ran.timedOut || (by({SIGKILL, SIGXCPU}) && ran.canHaveUsed(kSeconds)))
        return fmt::format("it could not be read within {} s", kSeconds);
    if (by({SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}))
        return "it is damaged: it cannot even be looked at";
    if (by({SIGXFSZ}))
        return fmt::format("it is larger than {} MiB", kMostMib);
    return "";
}

/// Unpacks the file job/archive/file, which the sandbox may read already.
Unpacked unpackFile(const Toolchain& tools, const Sandbox& sandbox, const Job& job,
                    const std::string& name, const std::vector<std::string>& known) {
    Unpacked unpacked{job.work.path() / "unpacked", "", ""};
    const fs::path file = job.work.path() / "archive" / "file";
    makeClosedFolder(unpacked.folder);
    shareWithSandbox(unpacked.folder, job.user.id(), true);

    Confinement confinement = confinementOf(job);
    confinement.readable = {tools.kit, file.parent_path()};
    confinement.writable = {unpacked.folder};
    confinement.workingFolder = unpacked.folder;
    confinement.programs.emplace();
    const ProcessResult ran =
        run(sandbox.confine(confinement, {tools.unpack().string(), file.string(), unpacked.folder}),
            kClockSeconds);
    unpacked.refusal = theirDoing(ran);
    if (unpacked.refusal.empty() && ran.exitCode == 1)
        unpacked.refusal = ran.output.substr(0, ran.output.find('\n'));
    if (unpacked.refusal.empty() && ran.exitCode != 0)
        throw Error("{} cannot be unpacked: {}", name, ran.output);
    while (const auto only =
               unpacked.refusal.empty() ? onlyFolderIn(unpacked.folder) : std::nullopt) {
        const std::string inner = only->filename().string();
        if (std::find(known.begin(), known.end(), inner) != known.end())
            break;
        unpacked.folder = *only;
        unpacked.notice +=
            (unpacked.notice.empty() ? "taken out of the archive's folder " : "/") + inner;
    }
    return unpacked;
}

/// Copies regular files, nothing else. False when they are larger together than an archive may be.
bool copyRegularFiles(const fs::path& from, const fs::path& to, std::uintmax_t& bytes) {
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(from)) {
        const fs::path target = to / entry.path().filename();
        const auto type = entry.symlink_status().type();
        if (type == fs::file_type::directory) {
            if (!copyRegularFiles(entry.path(), target, bytes))
                return false;
        } else if (type == fs::file_type::regular) {
            bytes += entry.file_size();
            if (bytes > kLargestArchive)
                return false;
            fs::copy_file(entry.path(), target);
        }
    }
    return true;
}

/// Of a repository what a commit is made of: no hook, no configuration, no link to another one.
bool copyCommits(const fs::path& repository, const fs::path& target) {
    std::uintmax_t bytes = 0;
    fs::create_directories(target);
    for (const char* each : {"HEAD", "packed-refs", "shallow"}) {
        if (typeOf(repository / each) != fs::file_type::regular)
            continue;
        bytes += fs::file_size(repository / each);
        if (bytes > kLargestArchive)
            return false;
        fs::copy_file(repository / each, target / each);
    }
    for (const char* each : {"objects", "refs"})
        if (typeOf(repository / each) == fs::file_type::directory &&
            !copyRegularFiles(repository / each, target / each, bytes))
            return false;
    fs::create_directories(target / "refs");
    fs::create_directories(target / "objects");
    fs::remove(target / "objects/info/alternates");
    return true;
}

}  // namespace

std::optional<fs::path> repositoryIn(const fs::path& folder) {
    for (const fs::path& each : {folder / ".git", folder})
        if (typeOf(each / "HEAD") == fs::file_type::regular &&
            typeOf(each / "objects") == fs::file_type::directory &&
            typeOf(each / "refs") == fs::file_type::directory &&
            typeOf(each) == fs::file_type::directory)
            return each;
    return std::nullopt;
}

Unpacked unpackArchive(const Toolchain& tools, const Sandbox& sandbox, const Job& job,
                       const fs::path& archive, const std::vector<std::string>& known) {
    std::error_code failed;
    if (fs::file_size(archive, failed) > kLargestArchive && !failed)
        return {{}, fmt::format("it is larger than {} MiB", kMostMib), ""};
    const fs::path copy = job.work.path() / "archive" / "file";
    makeClosedFolder(copy.parent_path());
    fs::copy_file(archive, copy, failed);
    if (failed == std::errc::permission_denied)
        return {{}, kUnreadable, ""};
    if (failed)
        throw Error("{} cannot be read: {}", archive.string(), failed.message());
    shareWithSandbox(copy.parent_path(), job.user.id(), false);
    return unpackFile(tools, sandbox, job, archive.string(), known);
}

Unpacked unpackClone(const Toolchain& tools, const Sandbox& sandbox, const Job& job,
                     const fs::path& repository, const std::vector<std::string>& known) {
    const fs::path bare = job.work.path() / "repository", made = job.work.path() / "archive";
    makeClosedFolder(bare);
    try {
        if (!copyCommits(repository, bare))
            return {{}, fmt::format("its history is larger than {} MiB", kMostMib), ""};
    } catch (const fs::filesystem_error& error) {
        if (error.code() != std::errc::permission_denied)
            throw;
        return {{}, kUnreadable, ""};
    }
    makeClosedFolder(made);
    shareWithSandbox(bare, job.user.id(), true);
    shareWithSandbox(made, job.user.id(), true);
    Confinement confinement = confinementOf(job);
    confinement.readable = {bare};
    confinement.writable = {made};
    confinement.workingFolder = made;
    confinement.programs = {"git"};
    confinement.environment = {"GIT_CONFIG_NOSYSTEM=1", "GIT_CONFIG_GLOBAL=/dev/null"};
    const ProcessResult ran =
        run(sandbox.confine(confinement,
                            {"git", "-c", "safe.directory=*", "--git-dir=" + bare.string(),
                             "archive", "--format=tar", "-o", (made / "file").string(), "HEAD"}),
            kClockSeconds);
    if (const std::string refusal = theirDoing(ran); !refusal.empty())
        return {{}, refusal, ""};
    if (sandboxFailed(ran) || ran.signal != 0 || ran.endedBy(SIGKILL))
        throw Error("git cannot be run for {}: {}", repository.string(), ran.output);
    if (!ran.succeeded())
        return {{}, "git cannot read its commit HEAD", ""};
    return unpackFile(tools, sandbox, job, repository.string(), known);
}

}  // namespace grader
