#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

namespace fs = std::filesystem;

/// What kind of thing is there, of a link the link itself. fs::file_type::none where that cannot be
/// known: no rights, a link in a circle on the way.
fs::file_type typeOf(const fs::path& path);

/// Paths of all that is in a folder, sorted; nothing where it is no folder or cannot be read.
std::vector<fs::path> entriesOf(const fs::path& folder);

/// The whole file; throws Error when it cannot be read.
std::string readFile(const fs::path& path);

/// Writes by way of a temporary file and a rename, so that a reader never sees half of it; makes
/// the folders that are missing. Throws Error, and then leaves nothing behind.
void writeFile(const fs::path& path, const std::string& content);

/// Makes a folder, and those above it that are missing, which only this user can enter: what is
/// written into it is nobody else's to read, until shareWithSandbox() hands it over. Throws Error.
void makeClosedFolder(const fs::path& folder);

/// SHA-256 as 64 hexadecimal digits.
std::string sha256(const std::string& data);

/// Index of the first byte, `from` or later, that is not UTF-8 text; npos when all is well. A zero
/// byte is no text.
std::size_t firstInvalidUtf8(const std::string& text, std::size_t from = 0);

/// Holds the lock of a file, which it makes if need be, as long as it lives. Throws Error when the
/// file cannot be opened or locked.
class FileLock {
public:
    enum class Wait { yes, no };
    FileLock(const fs::path& file, Wait wait);
    ~FileLock();
    /// False when it did not wait, and somebody else has the lock.
    bool held() const { return held_; }
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

private:
    int file_;
    bool held_;
};

/// A new folder under the system's temporary folder, removed with all in it at the end. It is
/// locked as long as its process lives, so that what a killed one left behind can be told. Throws
/// Error when it cannot be made or locked.
class WorkFolder {
public:
    WorkFolder();
    ~WorkFolder();
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    void remove();

    fs::path path_;
    int lock_ = -1;
};

/// Removes work folders whose processes were killed: those that nobody has locked and that are
/// older than `minutes`. What cannot be removed stays.
void removeAbandonedWork(int minutes = 10);

}  // namespace grader
