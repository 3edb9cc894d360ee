#include "Documentation.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <utility>

namespace lab {

using namespace grader;

namespace {

std::vector<std::string> wordsOf(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;)
        words.push_back(word);
    return words;
}

/// "./grade", also from a folder further down.
bool isGrade(const std::string& word) {
    static const std::regex grade(R"((\./|(\.\./)+)grade)");
    return std::regex_match(word, grade);
}

std::string quoted(const std::string& text) {
    return "'" + std::regex_replace(text, std::regex("'"), "'\\''") + "'";
}

}  // namespace

Documentation::Documentation(const CourseCopy& copy) : copy_(copy) {
    const std::string file = (copy.root() / "grader/tests/documentation.json").string();
    const Json json = parseJsonFile(file);
    for (const Json& entry : json.at("not_run")) {
        notRun_.push_back({entry.at("begins"), entry.at("why")});
        if (notRun_.back().why.empty())
            throw Error("{}: \"{}\" is not run, and there is no \"why\"", file,
                        notRun_.back().begins);
    }
    for (const auto& [word, means] : json.at("words").items())
        words_[word] = means.get<std::string>();
    prepare_ = json.at("prepare").get<std::vector<std::string>>();
}

std::vector<std::string> Documentation::tryCommands(const std::string& page,
                                                    const std::string& markdown) {
    std::vector<std::string> findings;
    std::string folder = ".";
    int block = 0;
    for (const Command& command : commandsIn(markdown)) {
        if (command.block != block || command.inText)
            folder = ".";
        block = command.block;
        if (const std::string why = tryCommand(command, folder); !why.empty())
            findings.push_back(
                fmt::format("{}:{}: {}\n    {}", page, command.line, command.text, why));
    }
    return findings;
}

std::string Documentation::tryCommand(const Command& command, std::string& folder) {
    const auto listed = std::find_if(notRun_.begin(), notRun_.end(), [&](const Entry& each) {
        return (command.text + " ").starts_with(each.begins);
    });
    if (listed != notRun_.end()) {
        listed->used = true;
        return lookAt(command.text);
    }
    // "[ASSIGNMENT...]" may be left out.
    const std::string text =
        withWords(std::regex_replace(command.text, std::regex(R"( \[[^\]]*\])"), ""));
    const auto words = wordsOf(text);
    if (words[0] == "cd" && words.size() == 2) {
        folder = (fs::path(folder) / words[1]).lexically_normal().string();
        return fs::is_directory(copy_.root() / folder) ? "" : "there is no such folder";
    }
    if (!isGrade(words[0]))
        return "nothing tries this: it is no ./grade command, and grader/tests/documentation.json "
               "does not list it. (A block that is none of commands says so: ```text)";
    if (command.inText && text.find("…") != std::string::npos)
        return lookAtGrade(command.text);
    return runOnce(text, folder, command.inText);
}

std::string Documentation::runOnce(const std::string& line, const std::string& folder,
                                   bool mayBeMention) {
    const std::string key = folder + " " + line;
    if (const auto known = tried_.find(key); known != tried_.end())
        return known->second;
    const ProcessResult result = copy_.sh(line, folder, 300);
    std::string why;
    if (mayBeMention && result.exitCode == 2 &&
        std::regex_search(result.output, std::regex(" is required|[0-9] required")))
        why = lookAtGrade(line);
    else if (result.exitCode != 0 && result.exitCode != 1)
        why = fmt::format("ended with exit code {}: {}", result.exitCode, result.output);
    return tried_[key] = why;
}

std::string Documentation::lookAt(const std::string& command) {
    const auto words = wordsOf(command);
    if (isGrade(words[0]))
        return lookAtGrade(command);
    if (words[0] == "ninja") {
        for (std::size_t i = 1; i < words.size(); ++i) {
            if (words[i] == "-C" || words[i] == "-j")
                ++i;
            else if (!words[i].starts_with("-") &&
                     copy_.sh("ninja -C " + quoted(COURSE_BUILD) + " -t query " + quoted(words[i]))
                             .exitCode != 0)
                return "there is no target " + words[i];
        }
    }
    const bool ofTheCheckout = words[0].find('/') != std::string::npos && words[0].front() != '/' &&
                               !words[0].starts_with("build/");
    if (ofTheCheckout && !fs::exists(copy_.root() / words[0]))
        return "there is no " + words[0];
    return "";
}

std::string Documentation::lookAtGrade(const std::string& command) {
    const auto words = wordsOf(command);
    const std::string sub =
        words.size() > 1 && std::regex_match(words[1], std::regex("[a-z][a-z-]*")) ? words[1]
                                                                                   : "grade";
    auto help = help_.find(sub);
    if (help == help_.end()) {
        const ProcessResult result = copy_.sh("./grade " + sub + " --help");
        help = help_.emplace(sub, result.exitCode == 0 ? result.output : "").first;
    }
    if (help->second.find("./grade " + sub) == std::string::npos)
        return "./grade has no command " + sub;
    for (const std::string& word : words) {
        // What comes after the assignment is the window's own.
        const std::string option = word.substr(0, word.find('='));
        if (option.starts_with("--") && option != "--yes" && sub != "window" &&
            !std::regex_search(help->second, std::regex("[ ,]" + option + "[ ,\n]")))
            return "./grade " + sub + " --help does not know " + option;
    }
    return "";
}

void Documentation::prepare() {
    for (const std::string& line : std::exchange(prepare_, {}))
        if (const ProcessResult result = copy_.sh(line); result.exitCode != 0)
            throw Error("documentation.json prepares \"{}\", which ended with exit code {}: {}",
                        line, result.exitCode, result.output);
}

std::string Documentation::withWords(std::string text) {
    const std::string before = text;
    for (const auto& [word, means] : words_) {
        const std::regex whole("(^|[\\s/=])" + word + "(?=$|[\\s/])");
        if (!std::regex_search(text, whole))
            continue;
        usedWords_.insert(word);
        text = std::regex_replace(text, whole, "$01" + means);
    }
    text = std::regex_replace(text, std::regex("(^|\\s)/(tmp|shared)(?=$|[\\s/])"),
                              "$01" + copy_.root().string() + "/scratch/$2");
    if (text != before)
        prepare();
    return text;
}

std::vector<std::string> Documentation::tryLinks(const std::string& page,
                                                 const std::string& markdown) const {
    std::vector<std::string> findings;
    // What is in students/ is laid over the top of their copy.
    const fs::path folder =
        page.starts_with("students/") ? copy_.root() : (copy_.root() / page).parent_path();
    for (const Link& link : linksIn(markdown)) {
        const auto hash = link.target.find('#');
        const std::string path = link.target.substr(0, hash);
        const fs::path file = path.empty() ? copy_.root() / page : folder / path;
        std::string why;
        if (!fs::exists(file)) {
            why = "there is no such file";
        } else if (hash != std::string::npos && file.extension() == ".md") {
            const auto anchors = anchorsOf(readFile(file));
            if (std::find(anchors.begin(), anchors.end(), link.target.substr(hash + 1)) ==
                anchors.end())
                why = "no heading there has this anchor";
        }
        if (!why.empty())
            findings.push_back(fmt::format("{}:{}: {}: {}", page, link.line, link.target, why));
    }
    return findings;
}

std::vector<std::string> Documentation::unusedEntries() const {
    std::vector<std::string> unused;
    for (const Entry& each : notRun_)
        if (!each.used)
            unused.push_back(each.begins);
    for (const auto& [word, means] : words_)
        if (!usedWords_.contains(word))
            unused.push_back(word);
    return unused;
}

std::vector<std::string> pagesOf(const fs::path& root) {
    std::vector<std::string> pages;
    for (auto it = fs::recursive_directory_iterator(root); it != fs::recursive_directory_iterator();
         ++it) {
        const fs::path name = it->path().lexically_relative(root);
        const bool folder = it->is_directory();
        if (folder && (name == "build" || name == ".git" || name.filename() == "node_modules" ||
                       name == "grader/templates" || name == "scratch"))
            it.disable_recursion_pending();
        else if (!folder && name.extension() == ".md")
            pages.push_back(name.string());
    }
    std::sort(pages.begin(), pages.end());
    return pages;
}

}  // namespace lab
