#include "batch/Replay.h"

#include <cmath>

namespace grader {

namespace {

constexpr double kSame = 1e-6;

std::map<std::string, const Json*> checksOf(const Json& document) {
    std::map<std::string, const Json*> checks;
    if (document.contains("tasks"))
        for (const Json& task : document.at("tasks"))
            for (const Json& check : task.at("checks"))
                checks[check.at("id")] = &check;
    return checks;
}

std::string said(const Json& check) {
    return fmt::format("{} with {:g} points", check.at("status").get<std::string>(),
                       check.at("points").get<double>());
}

bool same(const Json& a, const Json& b) {
    return a.at("status") == b.at("status") &&
           std::abs(a.at("points").get<double>() - b.at("points").get<double>()) < kSame;
}

}  // namespace

std::vector<std::string> differencesOf(const Json& then, const Json& now) {
    std::vector<std::string> differences;
    if (then.at("status") != now.at("status"))
        differences.push_back(fmt::format("then {}, now {}", then.at("status").get<std::string>(),
                                          now.at("status").get<std::string>()));
    const auto before = checksOf(then), after = checksOf(now);
    for (const auto& [id, check] : before)
        if (!after.contains(id))
            differences.push_back(id + " is not checked any more");
        else if (!same(*check, *after.at(id)))
            differences.push_back(
                fmt::format("{}: then {}, now {}", id, said(*check), said(*after.at(id))));
    for (const auto& [id, check] : after)
        if (!before.contains(id))
            differences.push_back(id + " was not checked then");
    return differences;
}

std::vector<std::string> changesOfEnvironment(const Json& then, const Json& now) {
    std::vector<std::string> changes;
    for (const auto& [name, value] : then.at("environment").items())
        if (now.at("environment").value(name, "") != value)
            changes.push_back(fmt::format("{}: then {}, now {}", name, value.get<std::string>(),
                                          now.at("environment").value(name, "")));
    return changes;
}

}  // namespace grader
