#include <chrono>

#include "HostileCase.h"

namespace hostile {

namespace {

constexpr double kMostSeconds = 300;

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Runs the grader; what it printed, or how it failed where it did not end with one of `codes`.
Shown run(std::vector<std::string> command, const World& world, const std::set<int>& codes) {
    if (world.plain())
        command.push_back("--no-sandbox");
    const auto start = std::chrono::steady_clock::now();
    const auto ran = grader::run(command, kMostSeconds);
    Shown shown;
    shown.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    shown.terminal = ran.output;
    shown.refused = ran.exitCode == 2 && holds(ran.output, "the archive is refused: ");
    if (ran.timedOut)
        shown.failure = "hangs";
    else if (!codes.contains(ran.exitCode) && !shown.refused)
        shown.failure = fmt::format("exit code {}", ran.exitCode);
    return shown;
}

/// All names and texts of a document.
void collectTexts(const Json& json, std::string& text) {
    if (json.is_string())
        text += json.get<std::string>() + "\n";
    if (!json.is_structured())
        return;
    for (const auto& [key, each] : json.items()) {
        text += key + "\n";
        collectTexts(each, text);
    }
}

std::string withoutEntities(std::string text) {
    const std::pair<std::string, std::string> entities[] = {
        {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}};
    for (const auto& [entity, letter] : entities)
        for (auto at = text.find(entity); at != std::string::npos;
             at = text.find(entity, at + letter.size()))
            text.replace(at, entity.size(), letter);
    return text;
}

}  // namespace

Shown gradeAlone(const fs::path& submission, const std::string& assignment, const World& world,
                 bool withPage) {
    const lab::WorkFolder out;
    const fs::path result = out.path() / "result.json", report = out.path() / "report";
    std::vector<std::string> command = {COURSE_GRADER,       assignment, "--submission",
                                        submission.string(), "--json",   result.string()};
    if (withPage)
        command.insert(command.end(), {"--report", report.string()});
    Shown shown = run(command, world, {0, 1});
    if (!shown.failure.empty() || shown.refused)
        return shown;
    shown.result = grader::readFile(result);
    if (withPage)
        shown.page = grader::readFile(report / "index.html");
    return shown;
}

Shown gradeInBatch(const fs::path& submission, const std::string& assignment, const World& world) {
    const std::string student = "attacker";
    const lab::WorkFolder work;
    const fs::path all = work.path() / "class", out = work.path() / "out";
    const std::string name = submission.filename().string();
    fs::create_directories(all);
    if (fs::is_directory(submission))
        fs::copy(submission, all / student,
                 fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    else
        fs::copy_file(submission, all / (student + name.substr(name.find('.'))));
    Shown shown = run({COURSE_GRADER, "batch", all.string(), "--assignment", assignment, "--out",
                       out.string(), "--jobs", "1"},
                      world, {0});
    if (!shown.failure.empty())
        return shown;
    const fs::path mine = out / "students" / student;
    shown.result = grader::readFile(mine / "result.json");
    shown.refused = Json::parse(shown.result).at("status") == "refused";
    if (!shown.refused) {
        shown.terminal += grader::readFile(mine / "report.txt");
        shown.page = grader::readFile(mine / "report/index.html");
    }
    return shown;
}

std::string withSingleBlanks(const std::string& text) {
    std::string words;
    for (const char each : text) {
        const bool blank = each == ' ' || each == '\n' || each == '\t' || each == '\r';
        if (!blank)
            words += each;
        else if (!words.empty() && words.back() != ' ')
            words += ' ';
    }
    return words;
}

std::string readable(const Shown& shown) {
    std::string texts;
    if (const Json document = Json::parse(shown.result, nullptr, false); !document.is_discarded())
        collectTexts(document, texts);
    return withSingleBlanks(shown.terminal + "\n" + texts + withoutEntities(shown.page));
}

}  // namespace hostile
