#include "pull_request/Changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "Collect.h"
#include "Error.h"
#include "Git.h"
#include "Regions.h"
#include "report/PlainText.h"

namespace grader {

namespace {

constexpr const char* kAssignments = "assignments/";
constexpr std::size_t kMostListed = 1u << 20;  // bytes of git's list of changes
constexpr std::size_t kMostUnused = 1000;

void refuseOddName(const std::string& commit) {
    const bool hexadecimal = commit.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!hexadecimal || (commit.size() != 40 && commit.size() != 64))
        throw Error("commit \"{}\": expected its full name, 40 hexadecimal digits", commit);
}

void refuseAbsent(const PullRequest& request) {
    const auto require = [&](const std::string& commit, const char* whose, const char* fetch) {
        refuseOddName(commit);
        const ProcessResult ran = git(request.repository, {"cat-file", "-e", commit + "^{commit}"});
        if (!ran.succeeded())
            throw Error("{} has no commit {}, the {}: fetch it first ({})\n{}",
                        request.repository.string(), commit, whose, fetch, ran.errors);
    };
    require(request.base, "base", "git fetch origin");
    require(request.head, "head", "git fetch origin pull/NUMBER/head");
}

/// Where the branch left the base's; the base itself where they have nothing in common.
std::string originOf(const PullRequest& request) {
    const ProcessResult ran = git(request.repository, {"merge-base", request.base, request.head});
    return ran.succeeded() ? ran.output.substr(0, ran.output.find('\n')) : request.base;
}

/// Path → assignment, for every file that students hand in, or may carry there (./grade carry).
std::map<std::string, std::string> studentPaths(const std::vector<Manifest>& course) {
    std::map<std::string, std::string> paths;
    for (const Manifest& each : course) {
        for (const std::string& file : each.submit)
            paths[pathOf(each.id, file)] = each.id;
        for (const auto& [file, from] : each.inherits)
            paths[pathOf(each.id, file)] = each.id;
    }
    return paths;
}

std::vector<std::string> keysOf(const std::map<std::string, std::string>& map) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : map)
        keys.push_back(key);
    return keys;
}

/// git diff-tree's "-z --name-status": a letter (and how alike), then one path, or two of a rename.
struct Entry {
    char letter = '?';
    std::string path, renamedTo;
};

std::vector<Entry> entriesOf(const std::string& output) {
    std::vector<Entry> entries;
    const auto parts = zeroEnded(output);
    for (std::size_t i = 0; i + 1 < parts.size();) {
        Entry entry{parts[i].empty() ? '?' : parts[i][0], parts[i + 1], ""};
        i += 2;
        if ((entry.letter == 'R' || entry.letter == 'C') && i < parts.size())
            entry.renamedTo = parts[i++];
        entries.push_back(std::move(entry));
    }
    return entries;
}

/// What the head's branch changed, below `paths` or anywhere. Where git was ended before it was
/// done, as for a tree that unfolds without end, the list is cut.
std::vector<Entry> differences(const PullRequest& request, const std::string& origin,
                               const std::vector<std::string>& options,
                               const std::vector<std::string>& paths, bool& cut) {
    std::vector<std::string> command = {"diff-tree",     "-r",           "-z", "--name-status",
                                        "--no-ext-diff", "--no-textconv"};
    command.insert(command.end(), options.begin(), options.end());
    command.insert(command.end(), {origin, request.head, "--"});
    command.insert(command.end(), paths.begin(), paths.end());
    const ProcessResult ran = git(request.repository, command, kMostListed);
    cut = !ran.succeeded();
    return entriesOf(ran.output);
}

/// The files of students that were renamed, and to what.
std::map<std::string, std::string> renamesIn(const PullRequest& request,
                                             const std::string& origin) {
    std::map<std::string, std::string> renames;
    bool cut = false;
    for (const Entry& each : differences(request, origin, {"-M", "--diff-filter=R"}, {}, cut))
        renames[each.path] = each.renamedTo;
    return renames;
}

using Regions = std::map<std::string, std::string>;

/// The regions of a file at a commit, whatever its line ends; none where it has no such file.
Regions regionsAt(const PullRequest& request, const std::string& commit, const std::string& path) {
    const ProcessResult ran = git(request.repository, {"cat-file", "blob", commit + ":" + path});
    std::string text = ran.succeeded() ? ran.output : "";
    std::erase(text, '\r');
    return regionsOf(text);
}

bool differIn(const Regions& before, const Regions& now, const std::string& task) {
    const auto was = before.find(task), is = now.find(task);
    if (was == before.end() || is == now.end())
        return (was == before.end()) != (is == now.end());
    return was->second != is->second;
}

/// The assignments that inherit a file of this one and have a task in it that was changed: one that
/// only uses the file is not what the student worked on.
std::vector<std::string> solvedIn(const PullRequest& request, const std::string& origin,
                                  const std::vector<Manifest>& course, const std::string& owner,
                                  const std::string& path) {
    const std::string file = path.substr(pathOf(owner, "").size());
    const Regions before = regionsAt(request, origin, path),
                  now = regionsAt(request, request.head, path);
    std::vector<std::string> all;
    for (const Manifest& each : course)
        if (const auto from = each.inherits.find(file);
            from != each.inherits.end() && from->second == owner &&
            std::any_of(each.tasks.begin(), each.tasks.end(),
                        [&](const Task& task) { return differIn(before, now, task.id); }))
            all.push_back(each.id);
    return all;
}

/// One sentence for each deleted file of a student.
std::vector<std::string> noticesOf(const PullRequest& request, const std::string& origin,
                                   const std::set<std::string>& deleted) {
    std::vector<std::string> notices;
    const auto renames =
        deleted.empty() ? std::map<std::string, std::string>() : renamesIn(request, origin);
    for (const std::string& path : deleted) {
        const auto renamed = renames.find(path);
        notices.push_back(renamed == renames.end()
                              ? fmt::format("{} was deleted", path)
                              : fmt::format("{} was renamed to {}: it is read only under its old "
                                            "name",
                                            path, renamed->second));
    }
    return notices;
}

std::string nameOf(const std::string& path) {
    return lowered(path.substr(path.rfind('/') + 1));
}

/// What a path may be meant for: the student's file of that path, or else of that name, but for
/// upper and lower case.
class Meanings {
public:
    Meanings(const std::vector<Manifest>& course, const std::map<std::string, std::string>& taken) {
        for (const Manifest& each : course)
            for (const std::string& file : each.submit)
                meant_.emplace(nameOf(file), pathOf(each.id, file));
        for (const auto& [path, assignment] : taken)
            meant_.emplace(lowered(path), path);
    }
    /// Empty for nothing.
    std::string of(const std::string& path) const {
        auto found = meant_.find(lowered(path));
        if (found == meant_.end())
            found = meant_.find(nameOf(path));
        return found == meant_.end() ? "" : found->second;
    }

private:
    std::map<std::string, std::string> meant_;
};

}  // namespace

std::string pathOf(const std::string& assignment, const std::string& file) {
    return kAssignments + assignment + "/" + file;
}

Changes changesOf(const PullRequest& request, const std::vector<Manifest>& course) {
    refuseAbsent(request);
    const std::string origin = originOf(request);
    const auto taken = studentPaths(course);
    Changes changes;
    bool cut = false;
    std::set<std::string> assignments, changed, deleted;
    for (const Entry& each : differences(request, origin, {}, keysOf(taken), cut)) {
        const auto at = taken.find(each.path);
        if (at == taken.end())
            continue;  // it lies in a folder that took a file's name
        changed.insert(each.path);
        assignments.insert(at->second);
        for (const std::string& id : solvedIn(request, origin, course, at->second, each.path))
            assignments.insert(id);
        if (each.letter == 'D')
            deleted.insert(each.path);
    }
    if (cut)
        throw Error("{}: git cannot compare {} with {}", request.repository.string(), origin,
                    request.head);
    changes.assignments.assign(assignments.begin(), assignments.end());
    changes.notices = noticesOf(request, origin, deleted);
    const Meanings meanings(course, taken);
    for (const Entry& each : differences(request, origin, {}, {}, changes.unusedCut)) {
        if (taken.contains(each.path))
            continue;
        const bool ofInstructors =
            each.path.starts_with("solutions/") || each.path.starts_with("grader/");
        const std::string meant =
            each.letter == 'A' && !ofInstructors ? meanings.of(each.path) : "";
        if (!meant.empty() && changed.insert(meant).second)  // told once
            changes.misplaced.push_back(fmt::format(
                "{} is not graded where it is: rename it to {}, or remove it", each.path, meant));
        if (changes.unused.size() < kMostUnused)
            changes.unused.push_back(each.path);
        else
            changes.unusedCut = true;
    }
    return changes;
}

std::vector<std::string> takeFiles(const PullRequest& request, const std::vector<Manifest>& course,
                                   const fs::path& folder) {
    const auto taken = studentPaths(course);
    std::vector<std::string> command = {"ls-tree", "-l", "-z", request.head, "--"};
    for (const std::string& path : keysOf(taken))
        command.push_back(path);
    const ProcessResult list = git(request.repository, command);
    if (!list.succeeded())
        throw Error("{}: git cannot list {}: {}", request.repository.string(), request.head,
                    list.errors);
    std::vector<std::string> notices;
    for (const std::string& line : zeroEnded(list.output)) {
        std::istringstream fields(line.substr(0, line.find('\t')));
        const std::string path = line.substr(line.find('\t') + 1);
        std::string mode, type, object, size;
        fields >> mode >> type >> object >> size;
        if (!taken.contains(path))
            continue;
        if (mode != "100644" && mode != "100755") {
            notices.push_back(path + " is no regular file and was not taken");
            continue;
        }
        if (std::stoull(size) > kLargestFile) {
            notices.push_back(
                fmt::format("{} has more than {} MiB and was not taken", path, kLargestFile >> 20));
            continue;
        }
        const ProcessResult content = git(request.repository, {"cat-file", "blob", object});
        if (!content.succeeded())
            throw Error("{}: git cannot read {}: {}", request.repository.string(), path,
                        content.errors);
        const fs::path target = folder / path.substr(std::string(kAssignments).size());
        writeFile(target, content.output);
    }
    return notices;
}

}  // namespace grader
