#include "HostileCase.h"

#include <algorithm>
#include <fstream>

#include "Error.h"

namespace hostile {

namespace {

using grader::Error;
using grader::Fields;

using Texts = std::vector<std::string>;

Texts oneOrMore(const Json& json) {
    return json.is_string() ? Texts{json.get<std::string>()} : json.get<Texts>();
}

Case readCase(const fs::path& folder) {
    const fs::path file = folder / "expect.json";
    const Json json = grader::parseJsonFile(file.string());
    Fields fields(json, file.string());
    Case attack;
    attack.folder = folder;
    attack.name = folder.filename().string();
    attack.about = fields.get<std::string>("about");
    attack.assignment = fields.get<std::string>("assignment");
    attack.mostPoints = fields.get<double>("most_points");
    const auto verdicts = oneOrMore(fields.get<Json>("verdict"));
    attack.verdicts = {verdicts.begin(), verdicts.end()};
    attack.file = fields.get<std::string>("file", "");
    attack.region = fields.get<std::string>("region", "");
    attack.says = oneOrMore(fields.get<Json>("says", Json::array()));
    attack.hides = fields.get<Texts>("hides", {});
    attack.escapes = fields.get<Texts>("escapes", {});
    attack.startsNoLine = fields.get<Texts>("starts_no_line", {});
    attack.ignored = fields.get<Texts>("ignored", {});
    attack.batch = fields.get<bool>("batch", false);
    attack.plain = fields.get<std::string>("plain", "");
    attack.withoutLandlock = fields.get<std::string>("without_landlock", "");
    fields.done();
    return attack;
}

/// The gravest status among the checks of a task, or of all tasks where `task` is empty.
std::string gravest(const Json& document, const std::string& task) {
    if (document.at("status") != "graded")
        return document.at("status");
    for (const char* status : {"grader_error", "tampered", "crash", "timeout", "memory", "output",
                               "build_error", "fail", "partial", "not_implemented", "skipped"})
        for (const Json& each : document.at("tasks"))
            if (task.empty() || each.at("id") == task)
                for (const Json& check : each.at("checks"))
                    if (check.at("status") == status)
                        return status;
    return "pass";
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

std::vector<Case> readCases(const fs::path& home, const std::string& only) {
    std::vector<Case> cases;
    for (const auto& entry : fs::directory_iterator(home))
        if (entry.is_directory() && holds(entry.path().filename().string(), only))
            cases.push_back(readCase(entry.path()));
    std::sort(cases.begin(), cases.end(),
              [](const Case& a, const Case& b) { return a.name < b.name; });
    if (cases.empty())
        throw Error("{} has no case with \"{}\" in its name", home.string(), only);
    return cases;
}

namespace {

/// Complaints about what a student would see.
std::vector<std::string> complaintsAbout(const Shown& shown, const std::string& verdict,
                                         const Case& attack,
                                         const std::vector<std::string>& secrets) {
    std::vector<std::string> complaints;
    const std::string read = readable(shown);
    for (const std::string& secret : secrets)
        if (holds(read, withSingleBlanks(secret)))
            complaints.push_back("a secret can be read: " + secret);
    const std::pair<const char*, const std::string&> places[] = {{"terminal", shown.terminal},
                                                                 {"result", shown.result},
                                                                 {"page", shown.page},
                                                                 {"text of these", read}};
    for (const auto& [where, text] : places)
        for (const std::string& hidden : attack.hides)
            if (holds(text, hidden))
                complaints.push_back(fmt::format("\"{}\" is in the {}", hidden, where));
    for (const std::string& text : attack.escapes)
        if (holds(shown.page, text))
            complaints.push_back("\"" + text + "\" stands in the page as it is");
    for (const std::string& text : attack.startsNoLine)
        if (holds("\n" + shown.terminal, "\n" + text))
            complaints.push_back("a line of the terminal begins with \"" + text + "\"");
    const auto isTold = [&](const std::string& text) {
        return holds(shown.result + shown.terminal + read, text);
    };
    // What ran out of its time on a busy machine has not come to what it wanted to say.
    const bool late = verdict == "timeout" && attack.verdicts.size() > 1;
    if (!late && !attack.says.empty() &&
        std::none_of(attack.says.begin(), attack.says.end(), isTold))
        complaints.push_back(
            fmt::format("it does not say \"{}\"", fmt::join(attack.says, "\" or \"")));
    return complaints;
}

/// The outcome of a grading, yet without faults but the grader's own.
Outcome outcomeOf(const Shown& shown, const std::string& task) {
    Outcome outcome;
    outcome.seconds = shown.seconds;
    if (!shown.failure.empty()) {
        outcome.verdict = shown.failure;
        outcome.faults.push_back("the grader itself failed: " + shown.terminal.substr(0, 500));
    } else if (shown.refused) {
        outcome.verdict = "refused";
    } else {
        outcome.document = Json::parse(shown.result);
        outcome.document.erase("timing");
        outcome.points = outcome.document.at("points");
        outcome.verdict = gravest(outcome.document, task);
    }
    return outcome;
}

Outcome graded(const Case& attack, const World& world) {
    const lab::WorkFolder work;
    fs::permissions(work.path(), fs::perms(0755));
    const fs::path submission = world.prepare(attack, work.path() / "submission");
    const Shown shown = attack.batch ? gradeInBatch(submission, attack.assignment, world)
                                     : gradeAlone(submission, attack.assignment, world, true);
    Outcome outcome = outcomeOf(shown, attack.region);
    for (std::string& each : complaintsAbout(shown, outcome.verdict, attack, world.secrets()))
        outcome.faults.push_back(std::move(each));
    for (const std::string& each : world.tracesOf(attack))
        outcome.faults.push_back("it has left a trace: " + each);
    if (!attack.verdicts.contains(outcome.verdict))
        outcome.faults.push_back(fmt::format("expected {}, got {}",
                                             fmt::join(attack.verdicts, " or "), outcome.verdict));
    if (outcome.document.is_null())
        return outcome;
    if (gravest(outcome.document, "") == "grader_error")
        outcome.faults.push_back("it is called the grader's own fault");
    if (outcome.points > attack.mostPoints + 1e-9)
        outcome.faults.push_back(
            fmt::format("earns {:g}, at most {:g} expected", outcome.points, attack.mostPoints));
    const Json& ignored = outcome.document.at("ignored_files");
    for (const std::string& name : attack.ignored)
        if (std::find(ignored.begin(), ignored.end(), name) == ignored.end())
            outcome.faults.push_back(name + " is not named as ignored");
    return outcome;
}

}  // namespace

Outcome tryCase(const Case& attack, const World& world) {
    try {
        return graded(attack, world);
    } catch (const std::exception& error) {
        Outcome outcome;
        outcome.faults.push_back(std::string("the case could not be tried: ") + error.what());
        return outcome;
    }
}

Outcome tryHonest(const std::string& assignment, const World& world) {
    Outcome outcome = outcomeOf(gradeAlone(world.honest(), assignment, world, false), "");
    if (!outcome.document.is_null() && outcome.verdict != "pass")
        outcome.faults.push_back("an honest submission lost points: " + outcome.verdict);
    return outcome;
}

Outcome tryHalfRight(const World& world) {
    Outcome outcome = outcomeOf(gradeAlone(world.halfRight(), kHalfRight, world, false), "");
    if (!outcome.document.is_null() && (outcome.points <= 0 || outcome.points >= 100))
        outcome.faults.push_back(
            fmt::format("a half-right submission earned {:g} points", outcome.points));
    return outcome;
}

std::vector<std::string> survivors() {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        std::ifstream file(entry.path() / "cmdline", std::ios::binary);
        std::string line;
        std::getline(file, line);  // nothing, when the process ends at this very moment
        std::replace(line.begin(), line.end(), '\0', ' ');
        if (line.starts_with("sleep 86399") || holds(line, "/kit/bin/runner "))
            found.push_back(line);
    }
    return found;
}

}  // namespace hostile
