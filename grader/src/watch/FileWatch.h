#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "Files.h"

namespace grader {

/// Tells when one of some files may have changed: written, replaced, removed, made.
///
/// Folders are watched and not the files, because many editors write a new file and give it the
/// old one's name. A file need not exist, nor its folder: then the nearest folder that does is
/// watched until it appears. Other files of the same folders wake nobody.
class FileWatch {
public:
    explicit FileWatch(std::vector<fs::path> files);
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// Can be read from when something has happened.
    int descriptor() const { return inotify_; }

    /// Takes what has happened. True when one of the files may have changed.
    bool takeEvents();

    /// Whether the system tells of every change. Not on file systems that another machine or
    /// another system may write to; then the caller has to look by itself, now and then.
    bool hearsEverything() const { return hearsEverything_; }

private:
    void arm();
    void watchFolder(const fs::path& folder, const std::string& name);

    std::vector<fs::path> files_;
    int inotify_;
    bool hearsEverything_ = true;
    std::map<int, std::set<std::string>> wanted_;  ///< names in a watched folder, by its number
};

/// What is in some files: a hash, the same for the same bytes; empty where there is no file.
using Contents = std::map<fs::path, std::string>;
Contents contentsOf(const std::vector<fs::path>& files);

/// Whether an editor may be in the middle of writing: a file that had something in it is gone, or
/// empty.
bool looksUnfinished(const Contents& before, const Contents& now);

}  // namespace grader
