#include "batch/Earlier.h"

#include <map>

#include "Error.h"
#include "batch/Ledger.h"
#include "batch/Written.h"

namespace grader {

namespace {

std::vector<Print> printsIn(const fs::path& folder, const std::string& assignment) {
    const fs::path results = folder / "results.json";
    if (!fs::exists(results))
        throw Error(
            "{} is not what ./grade batch or merge wrote to its --out: it has no results.json",
            folder.string());
    const std::string found =
        fromWritten(results, kGradeAgain,
                    [](const Json& document) -> std::string { return document.at("assignment"); });
    if (found != assignment)
        throw Error("{} holds results of {}, which are not compared with those of {}",
                    folder.string(), found, assignment);
    const Ledger ledger(folder);
    std::vector<Print> prints;
    if (fs::is_directory(folder / "instructor"))
        for (const auto& entry : fs::directory_iterator(folder / "instructor"))
            if (auto print = ledger.print(entry.path().filename().string())) {
                print->name = (folder / print->name).lexically_normal().string();
                prints.push_back(std::move(*print));
            }
    if (prints.empty())
        throw Error(
            "{} has no submission to compare with: its folder instructor/ is missing or empty",
            folder.string());
    return prints;
}

}  // namespace

std::vector<Print> earlierPrints(const std::vector<std::string>& folders,
                                 const std::string& assignment) {
    std::map<std::string, Print> all;  // in order, and each once
    for (const std::string& folder : folders)
        for (Print& print : printsIn(folder, assignment))
            all.insert_or_assign(print.name, std::move(print));
    std::vector<Print> prints;
    for (auto& [name, print] : all)
        prints.push_back(std::move(print));
    return prints;
}

}  // namespace grader
