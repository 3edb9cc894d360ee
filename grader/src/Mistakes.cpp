#include "Mistakes.h"

#include <algorithm>

#include "Error.h"
#include "Fields.h"
#include "Regions.h"

namespace grader {

std::vector<Mistake> readMistakes(const fs::path& solution) {
    const std::string file = (solution / "mistakes.json").string();
    const Json json = parseJsonFile(file);
    if (!json.is_array())
        throw Error("{}: expected an array of mistakes, found {}", file, json.type_name());
    std::vector<Mistake> mistakes;
    for (std::size_t i = 0; i < json.size(); ++i) {
        Fields fields(json.at(i), fmt::format("{}: [{}]", file, i));
        Mistake mistake;
        mistake.id = fields.get<std::string>("id");
        mistake.region = fields.get<std::string>("region");
        mistake.file = fields.get<std::string>("file");
        mistake.says = fields.get<std::string>("says");
        mistake.common = fields.get<std::string>("common", "");
        mistake.section = fields.get<std::string>("section");
        mistake.loses = fields.get<std::set<std::string>>("loses");
        mistake.earnsNothing = fields.get<bool>("earns_nothing", false);
        fields.done();
        mistake.body = readFile(solution / "mistakes" / mistake.fileName());
        if (const fs::path second = solution / "mistakes" / "second" / mistake.fileName();
            fs::exists(second))
            mistake.second = readFile(second);
        mistakes.push_back(std::move(mistake));
    }
    return mistakes;
}

std::string Mistake::fileName() const {
    return id + fs::path(file).extension().string();
}

std::vector<fs::path> variantsOf(const fs::path& solution) {
    std::vector<fs::path> folders;
    if (fs::is_directory(solution / "variants"))
        for (const auto& entry : fs::directory_iterator(solution / "variants"))
            folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    return folders;
}

void layOver(Stage& stage, const fs::path& folder) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        if (!entry.is_regular_file() || name == "loses.json")
            continue;
        StagedFile* file = stage.find(name);
        if (!file || file->role == Role::provided)
            throw Error("{} is no file that students hand in: remove it", entry.path().string());
        file->content = readFile(entry.path());
    }
}

Stage stageWith(Stage solution, const Mistake& mistake, const std::string& body) {
    StagedFile* file = solution.find(mistake.file);
    const auto text = file ? withRegion(file->content, mistake.region, body) : std::nullopt;
    if (!text)
        throw Error("mistake {}: the solution's {} has no region TODO({})", mistake.id,
                    mistake.file, mistake.region);
    file->content = *text;
    return solution;
}

std::vector<std::string> unexpectedLosses(const Mistake& mistake,
                                          const std::vector<CheckResult>& checks) {
    std::map<std::string, std::string> lost;
    for (const CheckResult& check : checks)
        if (!check.full())
            lost.emplace(check.task, check.id + ": " + check.message);
    std::vector<std::string> findings;
    if (!mistake.loses.contains(mistake.region))
        findings.push_back(fmt::format("mistake {}: \"loses\" must name its own task {}",
                                       mistake.id, mistake.region));
    for (const std::string& task : mistake.loses)
        if (!lost.contains(task))
            findings.push_back(
                fmt::format("mistake {} loses nothing in {}: no check there tells it from right",
                            mistake.id, task));
    for (const auto& [task, why] : lost)
        if (!mistake.loses.contains(task))
            findings.push_back(
                fmt::format("mistake {} also loses in {}, which its entry does not name: {}",
                            mistake.id, task, why));
    return findings;
}

}  // namespace grader
