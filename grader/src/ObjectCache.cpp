#include "ObjectCache.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "Error.h"
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
    try {
        return readFile(entry / "log");
    } catch (const Error&) {
        return std::nullopt;  // another grader has forgotten it meanwhile
    }
}

void ObjectCache::store(const std::string& key, const fs::path& made,
                        const std::string& log) const {
    if (fs::file_size(made) > kLargestEntry)
        return;
    const fs::path entry = folder_ / key;
    const std::string object = readFile(made);
    try {
        fs::create_directories(entry);
        writeFile(entry / "object", object);
        writeFile(entry / "log", log);  // last: its presence says that the entry is whole
        forgetOldest();
    } catch (const std::exception&) {
        // Forgotten by another grader at this very moment, or no room: that costs time, not a mark.
    }
}

void ObjectCache::forgetOldest() const {
    std::error_code gone;
    std::vector<std::pair<fs::file_time_type, fs::path>>
        entries;  // others may change them meanwhile
    for (const auto& entry : fs::directory_iterator(folder_))
        entries.emplace_back(fs::last_write_time(entry.path(), gone), entry.path());
    if (entries.size() <= kMostEntries)
        return;
    std::sort(entries.begin(), entries.end(), std::greater<>());
    // A quarter more than needed, so that this is rare.
    for (std::size_t i = kMostEntries * 3 / 4; i < entries.size(); ++i)
        fs::remove_all(entries[i].second, gone);
}

}  // namespace grader
