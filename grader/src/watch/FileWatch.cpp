#include "watch/FileWatch.h"

#include <sys/inotify.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "Collect.h"
#include "Error.h"

namespace grader {

namespace {

constexpr std::uint32_t kEvents = IN_CLOSE_WRITE | IN_MODIFY | IN_CREATE | IN_MOVED_TO |
                                  IN_MOVED_FROM | IN_DELETE | IN_DELETE_SELF | IN_MOVE_SELF |
                                  IN_ONLYDIR;

/// What happened to the watched folder itself.
constexpr std::uint32_t kFolderEvents = IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED | IN_UNMOUNT;

/// File systems that change without this kernel: NFS, SMB, those of virtual machines and of WSL
/// (9p, FUSE). The numbers are those of statfs(2).
bool changesUnheard(const fs::path& folder) {
    struct statfs status {};
    if (statfs(folder.c_str(), &status) != 0)
        return false;
    static constexpr unsigned long kinds[] = {0x6969,     0x517B,     0xFF534D42,
                                              0xFE534D42, 0x01021997, 0x65735546,
                                              0x786f4256, 0x00c36400, 0x5346414F};
    const auto kind = static_cast<unsigned long>(status.f_type) & 0xFFFFFFFF;
    return std::find(std::begin(kinds), std::end(kinds), kind) != std::end(kinds);
}

std::string hashOf(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(fs::status(file, error)))
        return "";
    // Too large to be taken: it need not be read to know that it is another one.
    if (const auto size = fs::file_size(file, error); !error && size > kLargestFile)
        return std::to_string(size);
    try {
        return sha256(readFile(file));
    } catch (const Error&) {
        return "";  // gone meanwhile, or not to be read
    }
}

}  // namespace

FileWatch::FileWatch(std::vector<fs::path> files)
    : files_(std::move(files)), inotify_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    for (fs::path& each : files_)
        each = fs::absolute(each).lexically_normal();
    hearsEverything_ = inotify_ >= 0;
    arm();
}

FileWatch::~FileWatch() {
    if (inotify_ >= 0)
        close(inotify_);
}

/// Watches the folder of each file, and each folder on the way there, so that one that is removed
/// and comes back is noticed.
void FileWatch::arm() {
    const auto before = std::exchange(wanted_, {});
    for (const fs::path& file : files_) {
        fs::path folder = file.parent_path();
        watchFolder(folder, file.filename().string());
        // The folder itself is a name in the one above; two levels suffice for what an editor, a
        // version control system or a student does to an assignment's folder while it exists.
        std::error_code error;
        for (int level = 0; folder.has_relative_path(); folder = folder.parent_path()) {
            watchFolder(folder.parent_path(), folder.filename().string());
            if (fs::is_directory(folder, error) && ++level == 2)
                break;
        }
    }
    for (const auto& [number, names] : before)
        if (!wanted_.contains(number))
            inotify_rm_watch(inotify_, number);  // it has moved elsewhere
}

void FileWatch::watchFolder(const fs::path& folder, const std::string& name) {
    hearsEverything_ = hearsEverything_ && !changesUnheard(folder);
    if (inotify_ < 0)
        return;
    const int number = inotify_add_watch(inotify_, folder.c_str(), kEvents);
    if (number >= 0)
        wanted_[number].insert(name);
    else if (errno == ENOSPC || errno == ENOMEM)
        hearsEverything_ = false;  // others use up all that the system allows
}

bool FileWatch::takeEvents() {
    if (inotify_ < 0)
        return false;
    bool changed = false, foldersChanged = false;
    alignas(inotify_event) char buffer[16384];
    for (ssize_t got; (got = read(inotify_, buffer, sizeof buffer)) > 0;)
        for (char* at = buffer; at < buffer + got;) {
            inotify_event event{};
            std::memcpy(&event, at, sizeof event);
            const std::string name = event.len > 0 ? at + sizeof event : "";
            at += sizeof event + event.len;
            const auto wanted = wanted_.find(event.wd);
            if (event.mask & IN_Q_OVERFLOW)
                foldersChanged = true;
            else if (wanted == wanted_.end())
                continue;
            else if (event.mask & kFolderEvents)
                foldersChanged = true;
            else if (wanted->second.contains(name)) {
                changed = true;
                foldersChanged = foldersChanged || (event.mask & IN_ISDIR);
            }
        }
    if (foldersChanged)
        arm();
    return changed || foldersChanged;
}

Contents contentsOf(const std::vector<fs::path>& files) {
    Contents contents;
    for (const fs::path& each : files)
        contents[each] = hashOf(each);
    return contents;
}

bool looksUnfinished(const Contents& before, const Contents& now) {
    static const std::string nothing = sha256("");
    return std::any_of(now.begin(), now.end(), [&](const auto& each) {
        const auto& [file, hash] = each;
        const auto old = before.find(file);
        const bool had = old != before.end() && !old->second.empty() && old->second != nothing;
        return had && (hash.empty() || hash == nothing);
    });
}

}  // namespace grader
