#include "Toolchain.h"

#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "Error.h"
#include "Sandbox.h"

namespace grader {

Toolchain Toolchain::load() {
    const fs::path file = fs::read_symlink("/proc/self/exe").parent_path() / "toolchain.json";
    try {
        const auto json = nlohmann::json::parse(readFile(file));
        Toolchain tools;
        tools.root = json.at("root").get<std::string>();
        tools.build = json.at("build").get<std::string>();
        const fs::path kit = fs::weakly_canonical(tools.build / "kit");
        tools.kit = reachableKit(kit);
        tools.kitFingerprint = fingerprintOf(kit);
        tools.cache = tools.build / "cache";
        tools.compiler = json.at("compiler");
        tools.compilerVersion = json.at("compiler_version");
        tools.glmVersion = json.at("glm_version");
        tools.version = json.at("version");
        tools.compileFlags = json.at("compile_flags");
        tools.linkFlags = json.at("link_flags");
        return tools;
    } catch (const nlohmann::json::exception& error) {
        throw Error("{} is not what the build writes ({}): run cmake --preset release again",
                    file.string(), error.what());
    }
}

namespace {

bool othersCanReach(const fs::path& path) {
    for (fs::path each = path; each != each.root_path(); each = each.parent_path()) {
        struct stat status {};
        if (stat(each.c_str(), &status) != 0 || (status.st_mode & 0001) == 0)
            return false;
    }
    return true;
}

void openToOthers(const fs::path& folder) {
    chmod(folder.c_str(), 0755);
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        chmod(entry.path().c_str(),
              entry.is_directory() || entry.path().parent_path().filename() == "bin" ? 0755 : 0644);
}

}  // namespace

std::string cpuModel() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string fingerprintOf(const fs::path& kit) {
    std::set<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(kit)) {
        struct stat status {};
        if (stat(entry.path().c_str(), &status) == 0 && S_ISREG(status.st_mode))
            files.insert(fmt::format("{} {} {}.{}", entry.path().string(), status.st_size,
                                     status.st_mtim.tv_sec, status.st_mtim.tv_nsec));
    }
    return sha256(fmt::format("{}", fmt::join(files, "\n"))).substr(0, 16);
}

fs::path reachableKit(const fs::path& kit) {
    if (geteuid() != 0 || othersCanReach(kit))
        return kit;
    // One copy per checkout: older ones of the same checkout are removed.
    const fs::path home = "/var/cache/graphics-course";
    const std::string checkout = sha256(kit.string()).substr(0, 16);
    const fs::path copy = home / (checkout + "-" + fingerprintOf(kit));
    if (fs::exists(copy))
        return copy;
    fs::create_directories(home);
    chmod(home.c_str(), 0755);
    // One at a time: who comes second finds the copy made, and nobody removes what is being made.
    const FileLock lock(home / "lock", FileLock::Wait::yes);
    if (fs::exists(copy))
        return copy;
    for (const auto& entry : fs::directory_iterator(home))
        if (entry.path().filename().string().starts_with(checkout))
            fs::remove_all(entry.path());
    const fs::path fresh = copy.string() + fmt::format(".new{}", getpid());
    fs::copy(kit, fresh, fs::copy_options::recursive);
    openToOthers(fresh);
    fs::rename(fresh, copy);
    return copy;
}

}  // namespace grader
