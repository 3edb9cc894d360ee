#include "HostileCase.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include "Error.h"
#include "Regions.h"

namespace hostile {

namespace {

using grader::Error;
using grader::Fields;

constexpr double kMostSeconds = 300;

std::string randomWord(const std::string& prefix) {
    std::random_device device;
    return prefix + fmt::format("{:08x}{:08x}", device(), device());
}

/// The lines of all hidden tests that could stand nowhere else.
std::vector<std::string> linesOfHiddenTests() {
    constexpr std::size_t kLong = 40;
    std::vector<std::string> lines;
    for (const auto& entry : fs::recursive_directory_iterator(lab::root() / "solutions")) {
        if (entry.path().parent_path().filename() != "hidden_tests" || !entry.is_regular_file())
            continue;
        std::istringstream file(grader::readFile(entry.path()));
        for (std::string line; std::getline(file, line);) {
            line.erase(0, line.find_first_not_of(' '));
            if (line.size() >= kLong && !line.starts_with("//"))
                lines.push_back(line);
        }
    }
    if (lines.empty())
        throw Error("{} has no hidden test", (lab::root() / "solutions").string());
    return lines;
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
    const Json verdict = fields.get<Json>("verdict");
    if (verdict.is_string())
        attack.verdicts = {verdict.get<std::string>()};
    else
        attack.verdicts = verdict.get<std::set<std::string>>();
    attack.file = fields.get<std::string>("file", "");
    attack.region = fields.get<std::string>("region", "");
    attack.says = fields.get<std::string>("says", "");
    using Texts = std::vector<std::string>;
    attack.hides = fields.get<Texts>("hides", {});
    attack.escapes = fields.get<Texts>("escapes", {});
    attack.startsNoLine = fields.get<Texts>("starts_no_line", {});
    attack.ignored = fields.get<Texts>("ignored", {});
    fields.done();
    return attack;
}

/// "body.cpp" in place of the region of a .cpp file or header, "body.frag" of a shader.
std::string partOf(const Case& attack, const std::string& part) {
    const std::string ending = attack.file.ends_with(".frag") ? ".frag" : ".cpp";
    const fs::path file = attack.folder / (part + ending);
    return fs::exists(file) ? grader::readFile(file) : "";
}

/// The archive that an attack has in its folder or has made; empty where there is none.
fs::path archiveIn(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().filename().string().starts_with("archive."))
            return entry.path();
    return {};
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
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

World::World() {
    secrets_ = {randomWord("secret_beside_"), randomWord("secret_of_the_neighbour_"),
                randomWord("secret_of_the_environment_")};
    const auto hidden = linesOfHiddenTests();
    secrets_.insert(secrets_.end(), hidden.begin(), hidden.end());
    fs::permissions(folder(), fs::perms(0755));
    grader::writeFile(folder() / "secret.txt", secrets_[0] + "\n");
    const std::string file = "06-rotation/rotation.cpp";
    grader::writeFile(folder() / "neighbour" / file,
                      "// " + secrets_[1] + "\n#error " + secrets_[1] + "\n" + honest_.read(file));
    const fs::path mistake = lab::root() / "solutions" / kHalfRight / "mistakes/euler-degrees.cpp";
    halfRight_.solve(file, "euler-rodrigues", grader::readFile(mistake));
    setenv("TOKEN_OF_THE_GRADER", secrets_[2].c_str(), 1);
}

bool World::isUntouched() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder()))
        names.insert(entry.path().filename().string());
    return names == std::set<std::string>{"secret.txt", "neighbour"} &&
           !fs::exists("/tmp/left-behind");
}

std::string World::filled(std::string text) const {
    replaceAll(text, "@ROOT@", lab::root().string());
    replaceAll(text, "@SECRET@", (folder() / "secret.txt").string());
    replaceAll(text, "@SIBLING@", (folder() / "neighbour").string());
    return text;
}

fs::path World::prepare(const Case& attack, const fs::path& target) const {
    fs::create_directories(target);
    fs::copy(honest() / attack.assignment, target / attack.assignment, fs::copy_options::recursive);
    if (!attack.file.empty()) {
        const fs::path file = target / attack.assignment / attack.file;
        std::string text = grader::readFile(file);
        if (!attack.region.empty()) {
            const auto put =
                grader::withRegion(text, attack.region, filled(partOf(attack, "body")));
            if (!put)
                throw Error("{}: {} has no region \"{}\"", attack.folder.string(), attack.file,
                            attack.region);
            text = *put;
        }
        grader::writeFile(file, filled(partOf(attack, "top")) + text);
    }
    if (const fs::path script = attack.folder / "make.sh"; fs::exists(script)) {
        const auto made = grader::run(
            {"bash", "-ec", "cd \"$0\"\n" + filled(grader::readFile(script)), target.string()},
            30.0);
        if (!made.succeeded())
            throw Error("{} failed: {}", script.string(), made.output);
    }
    for (const fs::path& folder : {target, attack.folder})
        if (const auto archive = archiveIn(folder); !archive.empty())
            return archive;
    return target;
}

namespace {

/// All that a student could be shown.
struct Shown {
    std::string terminal, result, page;
};

/// Grades a folder by the grader's own command, as a batch does, and reads all that it wrote.
Outcome gradeFolder(const fs::path& submission, const std::string& assignment, bool withPage,
                    Shown& shown) {
    const lab::WorkFolder out;
    const fs::path result = out.path() / "result.json", report = out.path() / "report";
    std::vector<std::string> command = {COURSE_GRADER,       assignment, "--submission",
                                        submission.string(), "--json",   result.string()};
    if (withPage)
        command.insert(command.end(), {"--report", report.string()});
    const auto start = std::chrono::steady_clock::now();
    const auto ran = grader::run(command, kMostSeconds);
    Outcome outcome;
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    shown.terminal = ran.output;
    if (ran.exitCode == 2 && holds(ran.output, "the archive is refused: ")) {
        outcome.verdict = "refused";
        return outcome;
    }
    if (ran.timedOut || (ran.exitCode != 0 && ran.exitCode != 1)) {
        outcome.verdict = ran.timedOut ? "hangs" : fmt::format("exit code {}", ran.exitCode);
        outcome.faults.push_back("the grader itself failed: " + ran.output.substr(0, 500));
        return outcome;
    }
    shown.result = grader::readFile(result);
    if (withPage)
        shown.page = grader::readFile(report / "index.html");
    outcome.document = Json::parse(shown.result);
    outcome.document.erase("timing");
    outcome.points = outcome.document.at("points");
    return outcome;
}

/// Complaints about what a student would see.
std::vector<std::string> complaintsAbout(const Shown& shown, const Case& attack,
                                         const std::vector<std::string>& secrets) {
    std::vector<std::string> complaints;
    const std::pair<const char*, const std::string&> places[] = {
        {"terminal", shown.terminal}, {"result", shown.result}, {"page", shown.page}};
    for (const auto& [where, text] : places) {
        for (const std::string& secret : secrets)
            if (holds(text, secret))
                complaints.push_back(fmt::format("a secret is in the {}: {}", where, secret));
        for (const std::string& hidden : attack.hides)
            if (holds(text, hidden))
                complaints.push_back(fmt::format("\"{}\" is in the {}", hidden, where));
    }
    for (const std::string& text : attack.escapes)
        if (holds(shown.page, text))
            complaints.push_back("\"" + text + "\" stands in the page as it is");
    for (const std::string& text : attack.startsNoLine)
        if (holds("\n" + shown.terminal, "\n" + text))
            complaints.push_back("a line of the terminal begins with \"" + text + "\"");
    if (!holds(shown.result + shown.terminal, attack.says))
        complaints.push_back("it does not say \"" + attack.says + "\"");
    return complaints;
}

}  // namespace

namespace {

Outcome graded(const Case& attack, const World& world) {
    const lab::WorkFolder work;
    fs::permissions(work.path(), fs::perms(0755));
    const fs::path submission = world.prepare(attack, work.path() / "submission");
    Shown shown;
    Outcome outcome = gradeFolder(submission, attack.assignment, true, shown);
    for (std::string& each : complaintsAbout(shown, attack, world.secrets()))
        outcome.faults.push_back(std::move(each));
    if (!world.isUntouched())
        outcome.faults.push_back("something was written beside the submission");
    if (!outcome.document.is_null())
        outcome.verdict = gravest(outcome.document, attack.region);
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
    Shown shown;
    Outcome outcome = gradeFolder(world.honest(), assignment, false, shown);
    if (outcome.document.is_null())
        return outcome;
    outcome.verdict = gravest(outcome.document, "");
    if (outcome.verdict != "pass")
        outcome.faults.push_back("an honest submission lost points: " + outcome.verdict);
    return outcome;
}

Outcome tryHalfRight(const World& world) {
    Shown shown;
    Outcome outcome = gradeFolder(world.halfRight(), kHalfRight, false, shown);
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
