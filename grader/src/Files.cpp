#include "Files.h"

#include <fcntl.h>
#include <sha2.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <memory>

#include "Error.h"

namespace grader {

namespace {

constexpr const char* kWorkPrefix = "course-";

}  // namespace

fs::file_type typeOf(const fs::path& path) {
    std::error_code unknown;
    return fs::symlink_status(path, unknown).type();
}

std::vector<fs::path> entriesOf(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code unreadable;
    for (fs::directory_iterator each(folder, unreadable), end; !unreadable && each != end;
         each.increment(unreadable))
        entries.push_back(each->path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

std::string readFile(const fs::path& path) {
    errno = 0;
    const auto refuse = [&] {
        throw Error("{} cannot be read: {}", path.string(),
                    errno == EISDIR ? "it is a folder" : std::strerror(errno));
    };
    const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
    if (!file)
        refuse();
    std::string content;
    char part[16384];
    for (std::size_t got; (got = std::fread(part, 1, sizeof part, file.get())) > 0;)
        content.append(part, got);
    if (std::ferror(file.get()))
        refuse();
    return content;
}

namespace {

void makeFoldersAbove(const fs::path& path) {
    std::error_code failed;
    if (path.has_parent_path())
        fs::create_directories(path.parent_path(), failed);
    if (failed)
        throw Error("{} cannot be made: {}", path.parent_path().string(), failed.message());
}

}  // namespace

void makeClosedFolder(const fs::path& folder) {
    makeFoldersAbove(folder);
    if (mkdir(folder.c_str(), 0700) != 0 && (errno != EEXIST || chmod(folder.c_str(), 0700) != 0))
        throw Error("{} cannot be made: {}", folder.string(), std::strerror(errno));
}

void writeFile(const fs::path& path, const std::string& content) {
    makeFoldersAbove(path);
    // A name of its own: other processes and threads may write the same file at the same time.
    static std::atomic<unsigned> written{0};
    const fs::path temporary = fmt::format("{}.new{}.{}", path.string(), getpid(), written++);
    std::ofstream file(temporary, std::ios::binary);
    file << content;
    file.close();
    if (!file) {
        const int why = errno;
        unlink(temporary.c_str());
        throw Error("{} cannot be written: {}", path.string(), std::strerror(why));
    }
    if (rename(temporary.c_str(), path.c_str()) != 0) {
        const int why = errno;
        unlink(temporary.c_str());
        throw Error("{} cannot be written: {}", path.string(), std::strerror(why));
    }
}

std::string sha256(const std::string& data) {
    char digest[SHA256_DIGEST_STRING_LENGTH];
    SHA256Data(reinterpret_cast<const std::uint8_t*>(data.data()), data.size(), digest);
    return digest;
}

std::size_t firstInvalidUtf8(const std::string& text, std::size_t from) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    for (std::size_t i = from; i < text.size();) {
        const unsigned char first = byte(i);
        std::size_t following = 0;
        unsigned low = 0x80, high = 0xBF;  // of the second byte
        if (first >= 0xC2 && first <= 0xDF)
            following = 1;
        else if (first >= 0xE0 && first <= 0xEF)
            following = 2, low = first == 0xE0 ? 0xA0 : 0x80, high = first == 0xED ? 0x9F : 0xBF;
        else if (first >= 0xF0 && first <= 0xF4)
            following = 3, low = first == 0xF0 ? 0x90 : 0x80, high = first == 0xF4 ? 0x8F : 0xBF;
        else if (first >= 0x80)
            return i;
        if (first == 0 || i + following >= text.size() + (following == 0))
            return i;
        for (std::size_t k = 1; k <= following; ++k, low = 0x80, high = 0xBF)
            if (byte(i + k) < low || byte(i + k) > high)
                return i;
        i += following + 1;
    }
    return std::string::npos;
}

FileLock::FileLock(const fs::path& file, Wait wait)
    : file_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
    if (file_ < 0)
        throw Error("{} cannot be written: {}", file.string(), std::strerror(errno));
    do
        held_ = flock(file_, LOCK_EX | (wait == Wait::no ? LOCK_NB : 0)) == 0;
    while (!held_ && errno == EINTR);
    if (!held_ && errno != EWOULDBLOCK) {
        const int why = errno;
        close(file_);
        throw Error("{} cannot be locked: {}", file.string(), std::strerror(why));
    }
}

FileLock::~FileLock() {
    close(file_);
}

WorkFolder::WorkFolder() {
    std::string name = (fs::temp_directory_path() / (kWorkPrefix + std::string("XXXXXX"))).string();
    if (!mkdtemp(name.data()))
        throw Error("no folder can be made for the work in {}: {}",
                    fs::temp_directory_path().string(), std::strerror(errno));
    path_ = name;
    chmod(name.c_str(), 0711);  // sandboxes pass through, nobody can list it
    lock_ = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock_ < 0 || flock(lock_, LOCK_EX | LOCK_NB) != 0) {
        const int why = errno;
        remove();
        throw Error("{} cannot be locked: {}", name, std::strerror(why));
    }
}

void WorkFolder::remove() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    if (lock_ >= 0)
        close(lock_);
}

WorkFolder::~WorkFolder() {
    remove();
}

void removeAbandonedWork(int minutes) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(), none)) {
        struct stat status {};
        const std::string path = entry.path().string();
        if (!entry.path().filename().string().starts_with(kWorkPrefix) ||
            lstat(path.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
            status.st_uid != geteuid() || status.st_ctime > std::time(nullptr) - 60 * minutes)
            continue;
        const int lock = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) == 0)
            fs::remove_all(entry.path(), none);
        if (lock >= 0)
            close(lock);
    }
}

}  // namespace grader
