#include "Collect.h"

#include <algorithm>
#include <set>
#include <utility>

#include "Error.h"
#include "Includes.h"
#include "Portability.h"
#include "Regions.h"

namespace grader {

namespace {

/// Files of the assignment's folder that are no part of a subject.
bool isProvided(const fs::path& name) {
    static const std::set<std::string> others = {"app.cpp", "README.md", "assignment.json"};
    const std::string top = name.begin()->string();
    if (top == "tests" || others.contains(name.string()))
        return false;
    static const std::set<std::string> kinds = {".h", ".cpp", ".inl", ".vert", ".frag", ".glsl"};
    return kinds.contains(name.extension().string());
}

std::size_t lineOf(const std::string& text, std::size_t position) {
    return 1 + static_cast<std::size_t>(
                   std::count(text.begin(), text.begin() + static_cast<long>(position), '\n'));
}

bool areSame(const fs::path& one, const fs::path& other) {
    std::error_code failed;
    return fs::equivalent(one, other, failed);
}

class Collector {
public:
    Collector(const fs::path& root, const Manifest& manifest, const Submission& submission)
        : root_(root), manifest_(manifest), submission_(submission) {}

    Collected run() {
        addProvided();
        for (const std::string& name : manifest_.submit)
            addOwn(name);
        for (const auto& [name, from] : manifest_.inherits)
            addInherited(name, from);
        noticeOwnHeaders();
        listIgnored();
        return std::move(result_);
    }

private:
    void addProvided() {
        std::set<std::string> student(manifest_.submit.begin(), manifest_.submit.end());
        for (const auto& [name, from] : manifest_.inherits)
            student.insert(name);  // a copy in the assignment's folder is the student's
        std::vector<fs::path> names;
        for (const auto& entry : fs::recursive_directory_iterator(manifest_.folder))
            if (entry.is_regular_file())
                names.push_back(entry.path().lexically_relative(manifest_.folder));
        std::sort(names.begin(), names.end());
        for (const fs::path& name : names)
            if (isProvided(name) && !student.contains(name.string()))
                result_.stage.files.push_back({name.string(), Role::provided, "assignment",
                                               readFile(manifest_.folder / name)});
    }

    void addOwn(const std::string& name) {
        if (const auto path = submission_.placeOf(manifest_, name)) {
            if (*path != folder_ / name) {
                elsewhere_.insert(path->filename().string());
                result_.notices.push_back(
                    fmt::format("{} is taken as {}", path->filename().string(), name));
            }
            return add(name, Role::own, "submission", *path);
        }
        const fs::path starter = root_ / "assignments" / manifest_.id / name;
        if (typeOf(starter) == fs::file_type::not_found)
            return refuseMissing(name, manifest_.id, folder_);
        const std::string other = inOtherCase(name, folder_);
        result_.notices.push_back(
            fmt::format("{} is missing: graded with the starter's file{}", name,
                        other.empty() ? "" : fmt::format("; {} is another: rename it", other)));
        add(name, Role::own, "starter", starter);
    }

    /// A file that was handed in under this name but for upper and lower case; empty for none.
    std::string inOtherCase(const std::string& name, const fs::path& folder) const {
        std::vector<std::string> names;
        for (const fs::path& place : {folder, (folder / name).parent_path()})
            for (const fs::path& each : submission_.entriesOf(place))
                names.push_back(each.lexically_relative(folder).string());
        const std::string other = nameInOtherCase(name, names);
        return other.empty() ? nameInOtherCase(fs::path(name).filename().string(), names) : other;
    }

    /// Where not even the starter is there to take its place: at home that is this very file.
    void refuseMissing(const std::string& name, const std::string& from, const fs::path& folder) {
        const std::string other = inOtherCase(name, folder);
        result_.unreadable.push_back(
            {"", 0, 0, "error",
             other.empty() ? missingStarter(from, name)
                           : fmt::format("{} is missing; {} is another: rename it", name, other),
             ""});
    }

    /// The source without which an inherited header is not used; empty where there is none.
    std::string sourceMissingFor(const std::string& header) const {
        for (const auto& [name, from] : manifest_.inherits)
            if (goesWith(manifest_, header, name) && !submission_.placeOf(manifest_, name))
                return name;
        return "";
    }

    void addInherited(const std::string& name, const std::string& from) {
        const auto path = submission_.placeOf(manifest_, name);
        if (!path && atHome_)
            return refuseMissing(name, from, submission_.folder / from);
        if (isHeader(name))
            result_.stage.coursesHeaders.push_back(substituteFor(root_, manifest_, name));
        if (path) {
            const std::string missing = sourceMissingFor(name);
            if (missing.empty() || atHome_)
                return add(name, Role::inherited, "submission", *path);
            result_.notices.push_back(
                fmt::format("{} of {} is not used without {}", name, from, missing));
        }
        StagedFile substitute = substituteFor(root_, manifest_, name);
        if (const auto tasks = tasksIn(manifest_, substitute.content); !tasks.empty())
            result_.notices.push_back(
                fmt::format("{} of {} is missing, and {} with it: expected it among the files "
                            "handed in",
                            name, from, fmt::join(tasks, ", ")));
        result_.stage.files.push_back(std::move(substitute));
    }

    void add(const std::string& name, Role role, const std::string& origin, const fs::path& path) {
        StagedFile file{name, role, origin, ""};
        const auto refuse = [&](int line, const std::string& why) {
            result_.unreadable.push_back({name, line, 0, "error", why});
        };
        std::error_code error;
        if (const std::string found = insteadOfFile(path); !found.empty())
            refuse(0, "expected a file, found " + found);
        else if (fs::file_size(path, error) > kLargestFile)
            refuse(0, "the file is larger than 4 MiB");
        else {
            try {
                file.content = readFile(path);
            } catch (const Error&) {
                refuse(0, "the file cannot be read: check its permissions");
            }
        }
        if (const auto bad = firstInvalidUtf8(file.content); bad != std::string::npos)
            refuse(static_cast<int>(lineOf(file.content, bad)),
                   fmt::format("the file is not UTF-8 (byte 0x{:02X}): save it with the encoding "
                               "UTF-8",
                               static_cast<unsigned char>(file.content[bad])));
        normalise(file);
        result_.stage.files.push_back(std::move(file));
    }

    /// What is there instead of a file of the student's own; empty when it is one. A link could
    /// lead to any file that the grader may read, so none is followed below the submission.
    std::string insteadOfFile(const fs::path& path) const {
        if (submission_.isBehindLink(path))
            return "a link: copy what it points to";
        switch (typeOf(path)) {
            case fs::file_type::regular:
                return "";
            case fs::file_type::directory:
                return "a folder";
            case fs::file_type::not_found:
                return "nothing";
            case fs::file_type::none:
                return "something that cannot be looked at: check its permissions";
            default:
                return "something else";
        }
    }

    /// Takes out what only some editors write.
    void normalise(StagedFile& file) {
        if (file.content.starts_with("\xEF\xBB\xBF"))
            file.content.erase(0, 3);
        std::string lines;
        for (std::size_t i = 0; i < file.content.size(); ++i)
            if (file.content[i] != '\r' || file.content.substr(i + 1, 1) != "\n")
                lines += file.content[i];
        file.content = std::move(lines);
    }

    /// At home a header of the student's own is found, among the course's; handed in, it is not
    /// taken.
    void noticeOwnHeaders() {
        for (const StagedFile& file : result_.stage.files)
            if (file.role == Role::own)
                for (const std::string& name : includedNames(file.content))
                    if (isOwnHeader(name))
                        result_.notices.push_back(
                            fmt::format("{0} includes {1}, which is none of the files to hand in: "
                                        "write what it holds into {0}",
                                        file.name, name));
    }
    /// Whether a header beside the student's files is theirs, and not to be handed in: what the
    /// course provides is included by a file of the course's, other than a source of that name.
    bool isOwnHeader(const std::string& name) const {
        const auto isIt = [&](const fs::path& file) { return file.filename() == name; };
        if (typeOf(folder_ / name) != fs::file_type::regular ||
            std::any_of(manifest_.submit.begin(), manifest_.submit.end(), isIt) ||
            manifest_.inherits.contains(name))
            return false;
        return std::none_of(result_.stage.files.begin(), result_.stage.files.end(),
                            [&](const StagedFile& file) {
                                return file.role == Role::provided &&
                                       fs::path(file.name).stem() != fs::path(name).stem() &&
                                       includedNames(file.content).contains(name);
                            });
    }

    /// Everything else in the submission's folder; a folder is one entry.
    void listIgnored() {
        for (const fs::path& path : submission_.entriesOf(folder_)) {
            const std::string name = path.filename().string();
            const StagedFile* taken = result_.stage.find(name);
            if (elsewhere_.contains(name) || isOurs(path))
                continue;
            if ((taken && taken->role == Role::provided) || (!taken && !holdsTaken(name)))
                result_.ignored.push_back(typeOf(path) == fs::file_type::directory ? name + "/"
                                                                                   : name);
        }
        std::sort(result_.ignored.begin(), result_.ignored.end());
    }
    /// Whether the assignment's folder has this very file, or the same.
    bool isOurs(const fs::path& path) const {
        const fs::path ours = manifest_.folder / path.filename();
        try {
            return fs::equivalent(path, ours) ||
                   (typeOf(path) == fs::file_type::regular && fs::is_regular_file(ours) &&
                    fs::file_size(path) <= kLargestFile && readFile(path) == readFile(ours));
        } catch (const std::exception&) {
            return false;  // there is none of ours, or theirs cannot be read
        }
    }
    bool holdsTaken(const std::string& folder) const {
        return std::any_of(
            result_.stage.files.begin(), result_.stage.files.end(), [&](const StagedFile& file) {
                return file.role != Role::provided && file.name.starts_with(folder + "/");
            });
    }

    const fs::path& root_;
    const Manifest& manifest_;
    const Submission& submission_;
    const fs::path folder_ = submission_.folderFor(manifest_.id);
    const bool atHome_ = submission_.perAssignment && areSame(folder_, manifest_.folder);
    std::set<std::string> elsewhere_;  ///< files above the subfolder that they belong in
    Collected result_;
};

}  // namespace

Submission submissionIn(const fs::path& folder, const std::vector<std::string>& known) {
    const auto hasOneOf = [&](const fs::path& in) {
        return std::any_of(known.begin(), known.end(), [&](const std::string& id) {
            return typeOf(in / id) == fs::file_type::directory;
        });
    };
    const fs::path inCopy = folder / "assignments";
    if (!hasOneOf(folder) && typeOf(inCopy) == fs::file_type::directory && hasOneOf(inCopy))
        return {fs::absolute(inCopy), true};
    return {fs::absolute(folder), hasOneOf(folder)};
}

fs::path Submission::folderFor(const std::string& assignment) const {
    return perAssignment ? folder / assignment : folder;
}

bool Submission::isBehindLink(const fs::path& path) const {
    const fs::path below = path.lexically_relative(folder);
    if (below.empty() || *below.begin() == "..")
        return false;
    fs::path step = folder;
    return std::any_of(below.begin(), below.end(), [&](const fs::path& part) {
        return part != "." && typeOf(step /= part) == fs::file_type::symlink;
    });
}

std::vector<fs::path> Submission::entriesOf(const fs::path& path) const {
    return isBehindLink(path) ? std::vector<fs::path>() : grader::entriesOf(path);
}

std::vector<fs::path> Submission::placesOf(const Manifest& manifest,
                                           const std::string& name) const {
    const fs::path own = folderFor(manifest.id);
    std::vector<fs::path> places = {own / name};
    const std::string last = fs::path(name).filename().string();
    if (const auto from = manifest.inherits.find(name); from != manifest.inherits.end()) {
        if (perAssignment)
            places.push_back(folder / from->second / name);
    } else if (std::count_if(manifest.submit.begin(), manifest.submit.end(),
                             [&](const fs::path& each) { return each.filename() == last; }) == 1) {
        places.push_back(own / last);
    }
    return places;
}

std::optional<fs::path> Submission::placeOf(const Manifest& manifest,
                                            const std::string& name) const {
    const std::vector<fs::path> places = placesOf(manifest, name);
    const auto found = std::find_if(places.begin(), places.end(), [](const fs::path& each) {
        return typeOf(each) != fs::file_type::not_found;
    });
    return found == places.end() ? std::nullopt : std::optional(*found);
}

StagedFile* Stage::find(const std::string& name) {
    return const_cast<StagedFile*>(std::as_const(*this).find(name));
}

const StagedFile* Stage::find(const std::string& name) const {
    for (const StagedFile& file : files)
        if (file.name == name)
            return &file;
    return nullptr;
}

std::vector<std::string> tasksIn(const Manifest& manifest, const std::string& text) {
    std::vector<std::string> tasks;
    for (const auto& [id, body] : regionsOf(text))
        if (manifest.task(id))
            tasks.push_back(id);
    return tasks;
}

std::map<std::string, fs::path> handedIn(const Manifest& manifest) {
    const fs::path assignments = manifest.folder.parent_path();
    std::map<std::string, fs::path> all;
    for (const std::string& name : manifest.submit)
        all[name] = manifest.folder / name;
    std::set<std::string> sources;
    for (const auto& [name, from] : manifest.inherits)
        if (const fs::path starter = assignments / from / name;
            fs::exists(starter) && !tasksIn(manifest, readFile(starter)).empty())
            sources.insert(from);
    for (const auto& [name, from] : manifest.inherits)
        if (sources.contains(from))
            all.emplace(name, assignments / from / name);
    return all;
}

std::string missingStarter(const std::string& assignment, const std::string& name) {
    return fmt::format("{} is missing: git restore assignments/{}/{} brings the starter's back",
                       name, assignment, name);
}

bool hasFileNamed(const std::map<std::string, fs::path>& handedIn, const std::string& name) {
    return std::any_of(handedIn.begin(), handedIn.end(),
                       [&](const auto& each) { return fs::path(each.first).filename() == name; });
}

bool isHeader(const std::string& name) {
    const std::string kind = fs::path(name).extension().string();
    return kind == ".h" || kind == ".hpp" || kind == ".inl";
}

bool goesWith(const Manifest& manifest, const std::string& header, const std::string& source) {
    return isHeader(header) && source.ends_with(".cpp") &&
           manifest.inherits.at(header) == manifest.inherits.at(source);
}

StagedFile substituteFor(const fs::path& root, const Manifest& manifest, const std::string& name) {
    const std::string& from = manifest.inherits.at(name);
    const fs::path solution = root / "solutions" / from / name,
                   starter = root / "assignments" / from / name;
    if (!fs::exists(starter))
        throw Error("{}: inherited file {} is nowhere in assignments/{}",
                    (manifest.folder / "assignment.json").string(), name, from);
    const std::string begun = readFile(starter);
    if (!fs::exists(solution))
        return {name, Role::inherited, "starter", begun};
    std::string content = readFile(solution);
    const auto regions = regionsOf(begun);
    for (const std::string& task : tasksIn(manifest, begun))
        content = withRegion(content, task, regions.at(task)).value_or(content);
    return {name, Role::inherited, "solutions", std::move(content)};
}

Collected collect(const fs::path& root, const Manifest& manifest, const Submission& submission) {
    return Collector(root, manifest, submission).run();
}

}  // namespace grader
