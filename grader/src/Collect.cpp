#include "Collect.h"

#include <algorithm>
#include <set>
#include <utility>

#include "Error.h"
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
        const fs::path folder = submission_.folderFor(manifest_.id, manifest_.id);
        if (fs::exists(fs::symlink_status(folder / name))) {
            result_.anythingSubmitted = true;
            add(name, Role::own, "submission", folder / name);
            return;
        }
        result_.notices.push_back(name + " is missing: graded with the starter's file");
        add(name, Role::own, "starter", root_ / "assignments" / manifest_.id / name);
    }

    /// Where the submission has an inherited file.
    std::optional<fs::path> inheritedAt(const std::string& name, const std::string& from) const {
        for (const std::string& id : {manifest_.id, from}) {
            const fs::path path = submission_.folderFor(id, manifest_.id) / name;
            if (fs::exists(fs::symlink_status(path)))
                return path;
        }
        return std::nullopt;
    }

    /// The source without which an inherited header is not used; empty where there is none.
    std::string sourceMissingFor(const std::string& header) const {
        for (const auto& [name, from] : manifest_.inherits)
            if (goesWith(manifest_, header, name) && !inheritedAt(name, from))
                return name;
        return "";
    }

    void addInherited(const std::string& name, const std::string& from) {
        if (isHeader(name))
            result_.stage.coursesHeaders.push_back(substituteFor(root_, manifest_, name));
        if (const auto path = inheritedAt(name, from)) {
            const std::string missing = sourceMissingFor(name);
            if (missing.empty())
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
        const fs::path below = path.lexically_relative(submission_.folder);
        if (!below.empty() && *below.begin() != "..") {
            fs::path step = submission_.folder;
            for (const fs::path& part : below)
                if (fs::is_symlink(fs::symlink_status(step /= part)))
                    return "a link: copy what it points to";
        }
        const fs::file_status status = fs::symlink_status(path);
        if (fs::is_regular_file(status))
            return "";
        return fs::is_directory(status) ? "a folder" : "something else";
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

    /// Everything else in the submission's folder; a folder is one entry.
    void listIgnored() {
        const fs::path folder = submission_.folderFor(manifest_.id, manifest_.id);
        if (!fs::is_directory(folder))
            return;
        for (const auto& entry : fs::directory_iterator(folder)) {
            const std::string name = entry.path().filename().string();
            const bool taken = result_.stage.find(name) != nullptr;
            const bool ours = fs::equivalent(folder, manifest_.folder) || sameAsOurs(entry, name);
            std::error_code circle;
            if (!taken && !ours && !holdsTaken(name))
                result_.ignored.push_back(entry.is_directory(circle) ? name + "/" : name);
            else if (taken && !ours && result_.stage.find(name)->role == Role::provided)
                result_.ignored.push_back(name);
        }
        std::sort(result_.ignored.begin(), result_.ignored.end());
    }
    bool sameAsOurs(const fs::directory_entry& entry, const std::string& name) const {
        const fs::path ours = manifest_.folder / name;
        try {
            return entry.is_regular_file() && fs::is_regular_file(ours) &&
                   entry.file_size() <= kLargestFile && readFile(entry.path()) == readFile(ours);
        } catch (const std::exception&) {
            return false;  // cannot be read, or a link in a circle
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
    Collected result_;
};

}  // namespace

Submission submissionIn(const fs::path& folder, const std::vector<std::string>& known) {
    const auto hasOneOf = [&](const fs::path& in) {
        return std::any_of(known.begin(), known.end(), [&](const std::string& id) {
            return fs::is_directory(fs::symlink_status(in / id));
        });
    };
    const fs::path inCopy = folder / "assignments";
    if (!hasOneOf(folder) && fs::is_directory(fs::symlink_status(inCopy)) && hasOneOf(inCopy))
        return {fs::absolute(inCopy), true};
    return {fs::absolute(folder), hasOneOf(folder)};
}

fs::path Submission::folderFor(const std::string& assignment, const std::string& graded) const {
    if (perAssignment)
        return folder / assignment;
    return assignment == graded ? folder : folder / ".." / assignment / "none";
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
