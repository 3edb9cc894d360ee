#include "watch/Watched.h"

#include <algorithm>

namespace grader {

bool Watched::isFull() const {
    return !result.is_null() && result.at("status") == "graded" && !firstLost(result);
}

bool Watched::ownChanged(const Contents& now) const {
    return std::any_of(own.begin(), own.end(), [&](const fs::path& file) {
        const auto before = graded.find(file);
        return before != graded.end() && before->second != now.at(file);
    });
}

std::vector<Watched> watchedOf(const fs::path& root, const Submission& submission,
                               const std::vector<std::string>& assignments) {
    std::vector<Watched> all;
    for (const std::string& id : assignments) {
        Watched one;
        one.manifest = loadAssignment(root, id);
        const fs::path folder = submission.folderFor(id, id);
        for (const std::string& name : one.manifest.submit)
            one.own.push_back(folder / name);
        one.files = one.own;
        for (const auto& [name, from] : one.manifest.inherits) {
            one.files.push_back(folder / name);
            if (submission.perAssignment)
                one.files.push_back(submission.folderFor(from, id) / name);
        }
        all.push_back(std::move(one));
    }
    return all;
}

std::vector<fs::path> filesOf(const std::vector<Watched>& all) {
    std::vector<fs::path> files;
    for (const Watched& each : all)
        files.insert(files.end(), each.files.begin(), each.files.end());
    return files;
}

}  // namespace grader
