#include "Lab.h"

#include <set>

#include "Regions.h"

namespace lab {

const Json& Graded::task(const std::string& id) const {
    for (const Json& task : document.at("tasks"))
        if (task.at("id") == id)
            return task;
    throw std::out_of_range("no task " + id + " in " + text);
}

const Json& Graded::check(const std::string& id) const {
    for (const Json& task : document.at("tasks"))
        for (const Json& check : task.at("checks"))
            if (check.at("id") == id)
                return check;
    throw std::out_of_range("no check " + id + " in " + text);
}

std::vector<std::string> Graded::losses() const {
    std::vector<std::string> ids;
    for (const Json& task : document.at("tasks"))
        if (task.at("status") != "pass")
            ids.push_back(task.at("id"));
    return ids;
}

bool Graded::notes(const std::string& part) const {
    for (const std::string notice : document.at("notices"))
        if (notice.find(part) != std::string::npos)
            return true;
    return false;
}

Submission::Submission() {
    // What is in solutions/ beside the student's files is not theirs.
    const std::set<std::string> ours = {"mistakes", "mistakes.json", "hidden_tests", "variants"};
    for (const auto& solution : fs::directory_iterator(root() / "solutions")) {
        const fs::path to = folder() / solution.path().filename();
        fs::create_directories(to);
        for (const auto& each : fs::directory_iterator(solution.path()))
            if (!ours.contains(each.path().filename().string()))
                fs::copy(each.path(), to / each.path().filename(), fs::copy_options::recursive);
    }
}

void Submission::write(const std::string& name, const std::string& content) {
    writeFile(file(name), content);
}

void Submission::solve(const std::string& name, const std::string& region,
                       const std::string& body) {
    const auto text = withRegion(read(name), region, body);
    ASSERT_TRUE(text) << name << " has no region " << region;
    write(name, *text);
}

void Submission::replace(const std::string& name, const std::string& from, const std::string& to) {
    std::string text = read(name);
    auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << name << " has no " << from;
    for (; at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    write(name, text);
}

Graded Submission::grade(const std::string& assignment, std::vector<std::string> more) const {
    more.insert(more.begin(), {assignment, "--submission", folder().string(), "--json", "-"});
    return runGrader(more);
}

fs::path root() {
    return COURSE_ROOT;
}

Graded runGrader(const std::vector<std::string>& arguments) {
    std::vector<std::string> command = {COURSE_GRADER};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult result = run(command, 120.0);
    Graded graded;
    graded.exitCode = result.exitCode;
    graded.text = result.output;
    graded.document = Json::parse(result.output, nullptr, false);
    if (graded.document.is_discarded())
        graded.document = nullptr;
    return graded;
}

}  // namespace lab
