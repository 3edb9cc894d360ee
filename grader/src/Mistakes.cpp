#include "Mistakes.h"

#include "Error.h"
#include "Fields.h"

namespace grader {

std::vector<Mistake> readMistakes(const fs::path& solution) {
    const std::string file = (solution / "mistakes.json").string();
    const Json json = parseJsonFile(file);
    std::vector<Mistake> mistakes;
    for (std::size_t i = 0; i < json.size(); ++i) {
        Fields fields(json.at(i), fmt::format("{}: [{}]", file, i));
        Mistake mistake;
        mistake.id = fields.get<std::string>("id");
        mistake.region = fields.get<std::string>("region");
        mistake.file = fields.get<std::string>("file");
        mistake.says = fields.get<std::string>("says");
        mistake.section = fields.get<std::string>("section");
        mistake.loses = fields.get<std::set<std::string>>("loses");
        fields.done();
        const std::string name = mistake.id + fs::path(mistake.file).extension().string();
        mistake.body = readFile(solution / "mistakes" / name);
        if (fs::exists(solution / "mistakes" / "second" / name))
            mistake.second = readFile(solution / "mistakes" / "second" / name);
        mistakes.push_back(std::move(mistake));
    }
    return mistakes;
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
