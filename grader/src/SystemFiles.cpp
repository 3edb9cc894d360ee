#include "SystemFiles.h"

#include <link.h>

#include <algorithm>
#include <set>

#include "Error.h"

namespace grader {

namespace {

constexpr const char* kFolders[] = {"/usr", "/bin", "/lib", "/lib32", "/lib64", "/libx32"};

/// Which of its libraries a program gets.
constexpr const char* kOfTheLoader[] = {"/etc/ld.so.cache", "/etc/alternatives"};

/// Where Mesa and the library that chooses a driver have their settings.
constexpr const char* kOfDrivers[] = {"/usr/share/glvnd", "/usr/share/drirc.d"};

template <class Names>
void addWhatIsThere(const Names& names, std::vector<fs::path>& to) {
    for (const fs::path name : names)
        if (fs::exists(name) && !fs::is_symlink(name))
            to.push_back(name);
}

bool isBelow(const fs::path& path, const fs::path& folder) {
    const fs::path rest = path.lexically_relative(folder);
    return !rest.empty() && *rest.begin() != "..";
}

bool isOfTheSystem(const fs::path& path) {
    for (const char* folder : kFolders)
        if (isBelow(path, folder))
            return true;
    return false;
}

/// The libraries of this process, with the loader itself.
std::vector<fs::path> loadedLibraries() {
    std::vector<fs::path> found;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* to) {
            if (*info->dlpi_name == '/')
                static_cast<std::vector<fs::path>*>(to)->emplace_back(info->dlpi_name);
            return 0;
        },
        &found);
    return found;
}

/// Paths of all libraries that the loader knows: its cache has them as strings that end in a zero.
std::vector<fs::path> cachedLibraries() {
    const char* cache = kOfTheLoader[0];
    if (!fs::exists(cache))
        return {};
    const std::string bytes = readFile(cache);
    std::vector<fs::path> found;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = std::min(bytes.find('\0', at), bytes.size());
        if (bytes[at] == '/')
            found.emplace_back(bytes.substr(at, end - at));
        at = end + 1;
    }
    return found;
}

/// Folders of libraries, without links; and the loader, whose path stands in every program.
std::vector<fs::path> foldersOfLibraries() {
    std::set<fs::path> asWritten, folders, loader;
    const auto add = [&](const fs::path& library) {
        asWritten.insert(library.parent_path());
        std::error_code none;
        if (const fs::path target = fs::read_symlink(library, none); target.has_parent_path())
            asWritten.insert(fs::weakly_canonical(library, none).parent_path());
    };
    fs::path home;  // of the C library
    for (const fs::path& library : loadedLibraries()) {
        add(library);
        if (const std::string name = library.filename().string(); name.starts_with("libc.so"))
            home = fs::canonical(library).parent_path();
        else if (name.starts_with("ld"))
            loader.insert(fs::canonical(library.parent_path()) / name);
    }
    for (const fs::path& library : cachedLibraries())
        add(library);
    for (const fs::path& each : asWritten) {
        std::error_code notThere;
        const fs::path folder = fs::canonical(each, notThere);
        // A folder above the libraries', /usr/lib for instance, has programs in others below it.
        const bool above = folder != home && isBelow(home, folder);
        if (!notThere && isOfTheSystem(folder) && !above)
            folders.insert(folder);
    }
    for (const fs::path& each : loader)
        if (!folders.count(each.parent_path()))
            folders.insert(each);
    return {folders.begin(), folders.end()};
}

}  // namespace

std::vector<fs::path> wholeSystem() {
    std::vector<fs::path> all;
    addWhatIsThere(kFolders, all);
    addWhatIsThere(kOfTheLoader, all);
    return all;
}

std::vector<fs::path> systemLinks() {
    std::vector<fs::path> links;
    for (const fs::path folder : kFolders)
        if (fs::is_symlink(folder))
            links.push_back(folder);
    return links;
}

std::vector<fs::path> librariesAnd(const std::vector<std::string>& programs) {
    static const std::vector<fs::path> libraries = foldersOfLibraries();
    std::vector<fs::path> all = libraries;
    addWhatIsThere(kOfTheLoader, all);
    addWhatIsThere(kOfDrivers, all);
    for (const std::string& name : programs)
        for (const fs::path folder : {"/usr/bin", "/bin"})
            if (!fs::is_symlink(folder) && fs::exists(folder / name))
                all.push_back(folder / name);
    return all;
}

void refuseAmongSystemFiles(const fs::path& secret) {
    if (isOfTheSystem(fs::weakly_canonical(fs::absolute(secret))))
        throw Error(
            "{} lies among the system's own files, where a submission's compiler may read: move it "
            "elsewhere, below /srv or a home for instance",
            secret.string());
}

}  // namespace grader
