#include "ObjectCache.h"

#include <algorithm>
#include <vector>

#include "Sandbox.h"

namespace grader {

std::optional<std::string> ObjectCache::fetch(const std::string& key,
                                              const fs::path& target) const {
    const fs::path entry = folder_ / key;
    std::error_code error;
    if (!fs::exists(entry / "log", error))
        return std::nullopt;
    fs::copy_file(entry / "object", target, error);
    if (error)
        return std::nullopt;
    fs::permissions(target, fs::perms(0644), error);  // the sandbox's user must read it
    fs::last_write_time(entry, fs::file_time_type::clock::now(), error);  // it is in use
    return readFile(entry / "log");
}

void ObjectCache::store(const std::string& key, const fs::path& made,
                        const std::string& log) const {
    const fs::path entry = folder_ / key;
    fs::create_directories(entry);
    writeFile(entry / "object", readFile(made));
    writeFile(entry / "log", log);  // last: its presence says that the entry is whole
    forgetOldest();
}

void ObjectCache::forgetOldest() const {
    std::vector<fs::directory_entry> entries{fs::directory_iterator(folder_),
                                             fs::directory_iterator()};
    if (entries.size() <= kMostEntries)
        return;
    std::error_code gone;
    std::sort(entries.begin(), entries.end(), [&](const auto& a, const auto& b) {
        return a.last_write_time(gone) > b.last_write_time(gone);
    });
    // A quarter more than needed, so that this is rare.
    for (std::size_t i = kMostEntries * 3 / 4; i < entries.size(); ++i)
        fs::remove_all(entries[i], gone);
}

}  // namespace grader
