#include "batch/Ledger.h"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>

#include <sstream>

namespace grader {

std::optional<Ledger::Known> Ledger::known(const std::string& entrant, const Key& key) const {
    const fs::path folder = folderOf(entrant);
    try {
        if (!fs::exists(folder / "key"))
            return std::nullopt;
        std::istringstream kept(readFile(folder / "key"));
        Key then;
        if (!(kept >> then.deciding >> then.wording) || then.deciding != key.deciding)
            return std::nullopt;
        return Known{parseJsonFile((folder / "result.json").string()), then.wording};
    } catch (const Error&) {
        return std::nullopt;
    }
}

void Ledger::begin(const std::string& entrant) const {
    std::error_code none;
    for (const char* each : {"key", "result.json", "report.txt"})
        fs::remove(folderOf(entrant) / each, none);
    fs::remove_all(folderOf(entrant) / "report", none);
    fs::remove_all(instructorFolderOf(entrant), none);
    fs::create_directories(folderOf(entrant));
}

void Ledger::keep(const std::string& entrant, const std::optional<Key>& key,
                  const std::string& result) const {
    writeFile(folderOf(entrant) / "result.json", result);
    if (!key)
        return;
    // Nothing may be lost by a power failure that the key vouches for.
    const int folder = open(folderOf(entrant).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool synchronised = folder >= 0 && syncfs(folder) == 0;
    const int why = errno;
    if (folder >= 0)
        close(folder);
    if (!synchronised)
        throw Error("{} cannot be made safe: {}", folderOf(entrant).string(), std::strerror(why));
    writeFile(folderOf(entrant) / "key", key->deciding + " " + key->wording + "\n");
}

void Ledger::keepSubmission(const std::string& entrant,
                            const std::map<std::string, std::string>& files,
                            const std::string& assignment) const {
    const fs::path home = submissionOf(entrant) / assignment;
    fs::create_directories(home);
    for (const auto& [name, content] : files)
        writeFile(home / name, content);
}

std::optional<Json> Ledger::instructorsResult(const std::string& entrant) const {
    const fs::path file = instructorFolderOf(entrant) / "result.json";
    return fs::exists(file) ? std::optional(parseJsonFile(file.string())) : std::nullopt;
}

void Ledger::keepInstructorsResult(const std::string& entrant, const std::string& result) const {
    writeFile(instructorFolderOf(entrant) / "result.json", result);
}

Json Ledger::record(const std::string& entrant) const {
    try {
        return parseJsonFile((instructorFolderOf(entrant) / "record.json").string());
    } catch (const Error&) {
        return Json::object();
    }
}

void Ledger::keepRecord(const std::string& entrant, const Json& record) const {
    writeFile(instructorFolderOf(entrant) / "record.json", record.dump(2) + "\n");
}

std::optional<Print> Ledger::print(const std::string& entrant) const {
    try {
        const Json json = parseJsonFile((instructorFolderOf(entrant) / "print.json").string());
        return Print{entrant, json.at("own").get<Fingerprints>(), json.at("exact")};
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

void Ledger::keepPrint(const Print& print) const {
    writeFile(instructorFolderOf(print.name) / "print.json",
              Json{{"own", print.own}, {"exact", print.exact}}.dump() + "\n");
}

}  // namespace grader
