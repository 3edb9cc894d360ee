#include <cg/Error.h>
#include <cg/Resources.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace cg {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path>& folders() {
    static std::vector<fs::path> instance;
    return instance;
}

bool isFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

std::vector<fs::path> candidates(const fs::path& name) {
    std::vector<fs::path> result{name};
    if (name.is_relative()) {
        for (const fs::path& folder : folders()) {
            result.push_back(folder / name);
        }
    }
    return result;
}

}  // namespace

std::string findResource(const std::string& name) {
    const std::vector<fs::path> tried = candidates(name);
    const auto found = std::find_if(tried.begin(), tried.end(), isFile);
    if (found != tried.end()) {
        return found->string();
    }
    std::string message = "file " + name + " not found; tried:";
    for (const fs::path& path : tried) {
        std::error_code ignored;
        message += "\n  " + fs::absolute(path, ignored).string();
    }
    throw Error(message);
}

void addResourceFolder(const std::string& path) {
    std::vector<fs::path>& all = folders();
    if (std::find(all.begin(), all.end(), fs::path(path)) == all.end()) {
        all.emplace_back(path);
    }
}

}  // namespace cg
