#include "package/PlatformPackage.h"

#include <fmt/ranges.h>

#include <set>

#include "Collect.h"
#include "Error.h"
#include "formats/Formats.h"
#include "report/Words.h"

namespace grader {

namespace {

constexpr const char* kPlatforms = "grader/platforms/";
constexpr const char* kNotGraded = "not-graded.json";

/// A package of the same commit, without files.
CourseFiles emptyPackage(const CourseFiles& course) {
    return {{}, course.seconds, course.commit};
}

/// Puts the course below `folder`.
void addCourse(CourseFiles& package, const CourseFiles& course, const std::string& folder) {
    for (const auto& [path, file] : course.files)
        package.files[folder + "/" + path] = file;
}

/// A line of Markdown for each task, with what a person gives apart.
std::string tableOf(const Manifest& manifest) {
    std::string table = "| problem | points | |\n|---|---|---|\n";
    for (const Task& task : manifest.tasks)
        table += fmt::format("| `{}` | {} | {}{} |\n", task.id, showPoints(task.points), task.title,
                             task.manual ? ", by a person" : "");
    return table;
}

/// The words between two @ in the scripts of grader/platforms.
std::map<std::string, std::string> wordsFor(const PackageOrder& order) {
    std::vector<std::string> files;
    for (const auto& [name, starter] : handedIn(order.manifest))
        files.push_back(fs::path(name).filename().string());  // platforms know no folders
    double automatic = 0, manual = 0;
    for (const Task& task : order.manifest.tasks)
        (task.manual ? manual : automatic) += task.points;
    return {{"@ASSIGNMENT@", order.manifest.id},
            {"@TITLE@", order.manifest.title},
            {"@SEED@", std::to_string(order.seed)},
            {"@COMMIT@", order.course.commit},
            {"@FILES@", fmt::format("{}", fmt::join(files, ","))},
            {"@AUTOMATIC@", showPoints(automatic)},
            {"@MANUAL@", showPoints(manual)},
            {"@TASKS@", tableOf(order.manifest)}};
}

/// A platform's script or page, with the words put in.
CourseFile scriptOf(const PackageOrder& order, const std::string& name) {
    const auto at = order.course.files.find(kPlatforms + name);
    if (at == order.course.files.end())
        throw Error("{}{} is not among the committed files: restore it (git checkout)", kPlatforms,
                    name);
    CourseFile file = at->second;
    for (const auto& [word, text] : wordsFor(order))
        for (auto from = file.content.find(word); from != std::string::npos;
             from = file.content.find(word, from + text.size()))
            file.content.replace(from, word.size(), text);
    return file;
}

/// An assignment and those that it takes files from, or has tasks that rest on theirs. Two may need
/// each other.
void addClosure(const Manifest& manifest, std::set<std::string>& ids) {
    ids.insert(manifest.id);
    const auto add = [&](const std::string& id) {
        if (!ids.contains(id))
            addClosure(Manifest::load(manifest.folder.parent_path() / id), ids);
    };
    for (const auto& [file, id] : manifest.inherits)
        add(id);
    for (const Task& task : manifest.tasks)
        for (const std::string& need : task.needs)
            if (const auto slash = need.find('/'); slash != std::string::npos)
                add(need.substr(0, slash));
}

/// solutions/, less what only a judge that is built with them can use.
void addSolutions(CourseFiles& package, const PackageOrder& order, const std::string& folder) {
    std::set<std::string> ids;
    addClosure(order.manifest, ids);
    for (const std::string& id : ids) {
        for (const auto& [path, file] : order.course.files)
            if (path.starts_with("solutions/" + id + "/"))
                package.files[folder + "/" + path] = file;
        package.remove(folder + "/solutions/" + id + "/hidden_tests");
    }
}

/// The bytes of a tar file with these files.
std::string tarOf(const CourseFiles& files) {
    const WorkFolder work;
    writeArchive(files, work.path() / "made.tar");
    return readFile(work.path() / "made.tar");
}

}  // namespace

CourseFiles gradescopePackage(const PackageOrder& order) {
    CourseFiles package = emptyPackage(order.course);
    for (const char* name : {"setup.sh", "run_autograder"})
        package.files[name] = scriptOf(order, fmt::format("gradescope/{}", name));
    package.files[kNotGraded] = {gradescopeFault()};
    addCourse(package, order.course, "course");
    return package;
}

CourseFiles prairieLearnPackage(const PackageOrder& order) {
    CourseFiles package = emptyPackage(order.course);
    package.files["README.md"] = scriptOf(order, "prairielearn/README.md");
    package.files["tests/run.sh"] = scriptOf(order, "prairielearn/run.sh");
    package.files[fmt::format("tests/{}", kNotGraded)] = {prairieLearnFault()};
    addSolutions(package, order, "tests");
    CourseFiles open = order.course;
    open.remove("solutions");
    addCourse(package, open, "image");
    return package;
}

CourseFiles autolabPackage(const PackageOrder& order) {
    CourseFiles package = emptyPackage(order.course), tar = emptyPackage(order.course);
    tar.files["run.sh"] = scriptOf(order, "autolab/run.sh");
    package.files["README.md"] = scriptOf(order, "autolab/README.md");
    package.files["autograde-Makefile"] = scriptOf(order, "autolab/autograde-Makefile");
    package.files["autograde.tar"] = {tarOf(tar)};
    package.files["Dockerfile.autolab"] = scriptOf(order, "autolab/Dockerfile");
    addCourse(package, order.course, "image");
    return package;
}

}  // namespace grader
