#include "watch/Watched.h"

#include <algorithm>

#include "Error.h"
#include "Regions.h"

namespace grader {

namespace {

/// Nothing of what is no file, or gone meanwhile, or not to be read.
std::string textOf(const fs::path& file) {
    try {
        return typeOf(file) == fs::file_type::regular ? readFile(file) : "";
    } catch (const Error&) {
        return "";
    }
}

/// As somebody who stands in the course's folder names it.
std::string shown(const fs::path& file, const Manifest& manifest) {
    const fs::path below = file.lexically_relative(manifest.folder.parent_path().parent_path());
    return below.empty() || *below.begin() == ".." ? file.string() : below.string();
}

}  // namespace

bool Watched::isFull() const {
    return !result.is_null() && result.at("status") == "graded" && !firstLost(result);
}

bool Watched::isBegun() const {
    if (result.is_null())
        return false;
    const Json& tasks = result.at("tasks");
    return std::any_of(tasks.begin(), tasks.end(), [](const Json& task) {
        return task.at("status") != "not_implemented" && task.at("status") != "pending";
    });
}

bool Watched::changed(const std::vector<fs::path>& some, const Contents& now) const {
    return std::any_of(some.begin(), some.end(), [&](const fs::path& file) {
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
        const auto add = [&](std::vector<fs::path>& to, const std::string& name) {
            const std::vector<fs::path> places = submission.placesOf(one.manifest, name);
            to.insert(to.end(), places.begin(), places.end());
        };
        one.names = one.manifest.submit;
        for (const std::string& name : one.manifest.submit)
            add(one.own, name);
        one.files = one.own;
        for (const auto& [name, from] : one.manifest.inherits)
            add(one.files, name);
        for (const auto& [name, starter] : handedIn(one.manifest))
            if (one.manifest.inherits.contains(name)) {
                one.names.push_back(name);
                add(one.shared, name);
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

std::string placeOfRegion(const Submission& submission, const Manifest& manifest,
                          const std::string& task) {
    std::vector<std::string> names = manifest.submit;
    for (const auto& [name, from] : manifest.inherits)
        names.push_back(name);
    for (const std::string& name : names)
        if (const auto file = submission.placeOf(manifest, name))
            if (const auto line = lineOfRegion(textOf(*file), task); line > 0)
                return fmt::format("{}:{}", shown(*file, manifest), line);
    return "";
}

}  // namespace grader
