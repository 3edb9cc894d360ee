#include "package/StudentCopy.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>

#include "Error.h"
#include "Manifest.h"
#include "Regions.h"
#include "package/Leaks.h"

namespace grader {

namespace {

constexpr const char* kOverlay = "students/";
constexpr const char* kTableHere = "<!-- assignments -->\n";

bool isIn(const std::vector<std::string>& all, const std::string& each) {
    return std::find(all.begin(), all.end(), each) != all.end();
}

/// The assignments that the copy has, in order.
std::vector<std::string> includedIn(const std::vector<std::string>& known,
                                    const std::string& upto) {
    const auto last = upto.empty() ? known.end() : std::find(known.begin(), known.end(), upto);
    if (last == known.end())
        return known;
    return {known.begin(), last + 1};
}

void refuseUnknown(const std::vector<std::string>& known, const std::vector<std::string>& included,
                   const StudentCopyWish& wish) {
    if (!wish.upto.empty() && !isIn(known, wish.upto))
        throw Error("--upto {}: there is no such assignment; known are {}", wish.upto,
                    fmt::join(known, ", "));
    for (const std::string& id : wish.withSolutions)
        if (!isIn(included, id))
            throw Error("--with-solutions {}: the copy has no such assignment, only {}", id,
                        fmt::join(included, ", "));
}

/// The files of `course` that are below one of the folders or are named so.
CourseFiles partOf(const CourseFiles& course, const std::vector<std::string>& starts) {
    CourseFiles part;
    for (const auto& [path, file] : course.files)
        if (std::any_of(starts.begin(), starts.end(),
                        [&](const std::string& each) { return path.starts_with(each); }))
            part.files[path] = file;
    return part;
}

/// An assignment takes files only from those before it, or students would miss them.
void refuseMissing(const fs::path& root, const std::vector<std::string>& included) {
    for (const std::string& id : included)
        for (const auto& [file, from] : loadAssignment(root, id).inherits)
            if (!isIn(included, from))
                throw Error("{} takes {} from {}, which is not in the copy: name a later --upto",
                            id, file, from);
}

std::string tableOf(const fs::path& root, const std::vector<std::string>& included) {
    std::string table = "| | | |\n|---|---|---|\n";
    for (const std::string& id : included) {
        const Manifest manifest = loadAssignment(root, id);
        table += fmt::format("| [{}](assignments/{}/README.md) | {} | {} |\n", id, id,
                             manifest.title, manifest.summary);
    }
    return table;
}

/// Lays students/ over the copy and writes the table of assignments into its README.
void layOver(CourseFiles& copy, const CourseFiles& all, const fs::path& root,
             const std::vector<std::string>& included) {
    const std::string overlay = kOverlay;
    for (const auto& [path, file] : partOf(all, {overlay}).files)
        copy.files[path.substr(overlay.size())] = file;
    std::string& readme = copy.files["README.md"].content;
    const std::size_t at = readme.find(kTableHere);
    if (at == std::string::npos)
        throw Error("{}: expected a line {} where the assignments are to be listed",
                    (root / kOverlay / "README.md").string(), kTableHere);
    readme.replace(at, std::string(kTableHere).size(), tableOf(root, included));
}

/// Where a relative link of a page leads: a path from the top.
std::string targetOf(const std::string& page, const std::string& link) {
    return (fs::path(page).parent_path() / link).lexically_normal().string();
}

/// A link from a page that students get, to what they do not get, becomes plain words.
void cutLinks(CourseFiles& copy, const CourseFiles& all) {
    static const std::regex link(R"(!?\[([^\]\[]*)\]\(([^)#: ]+)(#[^) ]*)?\))");
    for (auto& [path, file] : copy.files) {
        if (fs::path(path).extension() != ".md")
            continue;
        std::string text;
        const std::string& page = file.content;
        auto from = page.cbegin();
        for (std::sregex_iterator found(page.begin(), page.end(), link), end; found != end;
             ++found) {
            const std::string target = targetOf(path, (*found)[2]);
            const bool cut = all.files.contains(target) && !copy.files.contains(target);
            text.append(from, (*found)[0].first);
            text += cut ? (*found)[1].str() : (*found)[0].str();
            from = (*found)[0].second;
        }
        text.append(from, page.cend());
        file.content = text;
    }
}

/// A region as a file has it, fences included.
std::string fenced(const std::string& id, const std::string& text) {
    return fmt::format("// BEGIN TODO({})\n{}// END TODO({})\n", id, text, id);
}

/// Solutions that are given away, by path. A region in them that is a task of an assignment whose
/// solution is not given (08's perspective is solved in 07's Camera.cpp) is as the starter has it
/// in `shown`, and alone in `held`.
struct GivenSolutions {
    CourseFiles shown, held;
};

GivenSolutions givenSolutions(const CourseFiles& all, const fs::path& root,
                              const StudentCopyWish& wish) {
    std::set<std::string> tasks;
    for (const std::string& id : wish.withSolutions)
        for (const Task& task : loadAssignment(root, id).tasks)
            tasks.insert(task.id);
    GivenSolutions given;
    for (const std::string& id : wish.withSolutions)
        for (const std::string& name : loadAssignment(root, id).submit) {
            const std::string path = "solutions/" + id + "/" + name;
            const auto solved = all.files.find(path);
            if (solved == all.files.end())
                throw Error("--with-solutions {}: git keeps no {}", id, path);
            CourseFile shown = solved->second;
            const auto starter = regionsOf(all.files.at("assignments/" + id + "/" + name).content);
            for (const auto& [region, text] : regionsOf(solved->second.content))
                if (!tasks.contains(region)) {
                    shown.content = *withRegion(shown.content, region, starter.at(region));
                    given.held.files[path].content += fenced(region, text);
                }
            given.shown.files[path] = std::move(shown);
        }
    return given;
}

/// What may say the same as a solution: starters, and the framework's code.
CourseFiles openFiles(const CourseFiles& all, const fs::path& root,
                      const std::vector<std::string>& known) {
    static const std::vector<std::string> code = {".cpp", ".h", ".vert", ".frag"};
    CourseFiles open;
    for (const auto& [path, file] : partOf(all, {"common/"}).files)
        if (isIn(code, fs::path(path).extension().string()))
            open.files[path] = file;
    for (const std::string& id : known)
        for (const std::string& name : loadAssignment(root, id).submit) {
            const std::string path = "assignments/" + id + "/" + name;
            if (const auto starter = all.files.find(path); starter != all.files.end())
                open.files[path] = starter->second;
        }
    return open;
}

void refuseLeaks(const CourseFiles& copy, const CourseFiles& all, CourseFiles open,
                 const StudentCopyWish& wish, const GivenSolutions& given) {
    CourseFiles secret = partOf(all, {"solutions/"});
    for (const std::string& id : wish.withSolutions)
        secret.remove("solutions/" + id);
    for (const auto& [path, file] : given.held.files)
        secret.files[path] = file;
    for (const auto& [path, file] : given.shown.files)
        open.files[path] = file;
    std::string found;
    for (const Leak& leak : leaksOf(copy, secret, open))
        found += fmt::format("\n  {}: as in {}: {}", leak.path, leak.source, leak.words);
    if (!found.empty())
        throw Error(
            "the students' copy would give solutions away:{}\nWrite these otherwise, or leave the "
            "file out of the copy (attribute instructors in .gitattributes).",
            found);
    if (const auto binaries = unsearchable(copy); !binaries.empty())
        throw Error(
            "solutions could hide in these files of the students' copy, which are neither text nor "
            "pictures (.png):\n  {}\nTake them out of git, or leave them out of the copy "
            "(attribute "
            "instructors in .gitattributes).",
            fmt::join(binaries, "\n  "));
}

}  // namespace

CourseFiles studentCopy(const fs::path& root, const StudentCopyWish& wish) {
    const CourseFiles all = committedFiles(root);
    if (partOf(all, {kOverlay}).files.empty())
        throw Error(
            "{} has no {}, so this is a student's copy: copies are made where the solutions are",
            root.string(), kOverlay);
    auto known = knownAssignments(root);
    std::erase_if(known, [&](const std::string& id) {
        return !all.files.contains("assignments/" + id + "/assignment.json");
    });
    const auto included = includedIn(known, wish.upto);
    refuseUnknown(known, included, wish);
    refuseMissing(root, included);
    CourseFiles copy = committedFiles(root, "instructors");
    for (const std::string& id : known)
        if (!isIn(included, id)) {
            copy.remove("assignments/" + id);
            copy.remove("reference_images/" + id);
        }
    const GivenSolutions given = givenSolutions(all, root, wish);
    for (const auto& [path, file] : given.shown.files)
        copy.files[path] = file;
    layOver(copy, all, root, included);
    cutLinks(copy, all);
    refuseLeaks(copy, all, openFiles(all, root, known), wish, given);
    return copy;
}

std::vector<std::string> namesOfWhatIsLeftOut(const fs::path& root, const CourseFiles& copy) {
    auto leftOut = knownAssignments(root);
    std::erase_if(leftOut, [&](const std::string& id) {
        return copy.files.contains("assignments/" + id + "/assignment.json");
    });
    std::vector<std::string> found;
    for (const auto& [path, file] : copy.files) {
        std::vector<std::string> named;
        for (const std::string& id : leftOut)
            if (fs::path(path).extension() == ".md" && file.content.find(id) != std::string::npos)
                named.push_back(id);
        if (!named.empty())
            found.push_back(fmt::format("{} names what this copy does not have: {}", path,
                                        fmt::join(named, ", ")));
    }
    return found;
}

}  // namespace grader
