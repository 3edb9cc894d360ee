#include "Carry.h"

#include <algorithm>

#include "Error.h"
#include "Regions.h"

namespace grader {

namespace {

/// Whether every region of a file is as the starter has it. A file without regions is nobody's
/// starter, or cannot be told from it.
enum class Begun { yes, no, unknown };
Begun begunIn(const std::string& text) {
    const auto regions = regionsOf(text);
    if (regions.empty())
        return Begun::unknown;
    const bool blank = std::all_of(regions.begin(), regions.end(), [](const auto& region) {
        return region.second.find("cg::todo") != std::string::npos ||
               region.second.find("cg_todo_") != std::string::npos;
    });
    return blank ? Begun::no : Begun::yes;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

std::string possiblePairs(const fs::path& root) {
    std::vector<std::string> pairs;
    const auto known = knownAssignments(root);
    for (const std::string& from : known)
        for (const std::string& to : known)
            if (from != to &&
                !carriedNames(loadAssignment(root, from), loadAssignment(root, to)).empty())
                pairs.push_back(from + " " + to);
    return pairs.empty() ? "no assignment of this course uses files of another"
                         : fmt::format("possible are: {}", fmt::join(pairs, "; "));
}

fs::path freeBackupName(const fs::path& file) {
    fs::path name = file.string() + ".before-carry";
    for (int i = 2; fs::exists(fs::symlink_status(name)); ++i)
        name = fmt::format("{}.before-carry{}", file.string(), i);
    return name;
}

class Carrying {
public:
    Carrying(const fs::path& root, const std::string& from, const std::string& to, bool force)
        : root_(root),
          from_(loadAssignment(root, from)),
          to_(loadAssignment(root, to)),
          force_(force),
          names_(carriedNames(from_, to_)) {}

    std::string run() {
        if (from_.id == to_.id || names_.empty())
            throw Error("carry {} {}: {} uses no file that {} hands in; {}", from_.id, to_.id,
                        to_.id, from_.id, possiblePairs(root_));
        refuseStarter();
        refuseLosses();
        for (const std::string& name : names_)
            copy(name);
        text_ += fmt::format(
            "From now on these count for {}, in grading and in its window: go on changing them "
            "there.\nThose of {} stay what you hand in for {}.\n",
            to_.id, from_.id, from_.id);
        return text_;
    }

private:
    fs::path source(const std::string& name) const { return from_.folder / name; }
    fs::path target(const std::string& name) const { return to_.folder / name; }

    void refuseStarter() const {
        bool blank = false, filled = false;
        for (const std::string& name : names_) {
            if (!fs::is_regular_file(source(name)))
                throw Error("carry {} {}: {} is missing: expected the file that {} hands in",
                            from_.id, to_.id, source(name).string(), from_.id);
            const Begun begun = begunIn(readFile(source(name)));
            blank = blank || begun == Begun::no;
            filled = filled || begun == Begun::yes;
        }
        if (blank && !filled)
            throw Error(
                "carry {} {}: {} has not been begun: every TODO region in {} is as it was. Do {} "
                "first",
                from_.id, to_.id, from_.id, from_.folder.string(), from_.id);
    }

    /// There, and another file than the one to be copied.
    bool differs(const std::string& name) const {
        const fs::path file = target(name);
        if (!fs::exists(fs::symlink_status(file)))
            return false;
        if (!fs::is_regular_file(fs::symlink_status(file)))
            throw Error(
                "carry {} {}: expected a file or nothing at {}, found something else: "
                "move it away",
                from_.id, to_.id, file.string());
        return readFile(file) != readFile(source(name));
    }

    void refuseLosses() const {
        std::vector<std::string> changed;
        for (const std::string& name : names_)
            if (differs(name) && !force_ && begunIn(readFile(target(name))) != Begun::no)
                changed.push_back(name);
        if (!changed.empty())
            throw Error(
                "carry {} {}: {} in {} differs from yours of {}; nothing was copied. With --force "
                "it is replaced, and kept as *.before-carry",
                from_.id, to_.id, listed(changed), to_.folder.string(), from_.id);
    }

    void copy(const std::string& name) {
        const std::string path = fmt::format("assignments/{}/{}", to_.id, name);
        if (fs::exists(target(name)) && !differs(name)) {
            text_ += fmt::format("{} is the same file already\n", path);
            return;
        }
        std::string kept;
        if (fs::exists(target(name))) {
            const fs::path backup = freeBackupName(target(name));
            fs::copy_file(target(name), backup);
            kept = fmt::format("; what was there is kept as {}", backup.filename().string());
        }
        writeFile(target(name), readFile(source(name)));
        text_ += fmt::format("copied to {}{}\n", path, kept);
    }

    const fs::path& root_;
    const Manifest from_, to_;
    const bool force_;
    const std::vector<std::string> names_;
    std::string text_;
};

}  // namespace

std::vector<std::string> carriedNames(const Manifest& from, const Manifest& to) {
    std::vector<std::string> names;
    for (const std::string& name : from.submit) {
        const auto inherited = to.inherits.find(name);
        if ((inherited != to.inherits.end() && inherited->second == from.id) ||
            std::find(to.submit.begin(), to.submit.end(), name) != to.submit.end())
            names.push_back(name);
    }
    return names;
}

std::string carry(const fs::path& root, const std::string& from, const std::string& to,
                  bool force) {
    return Carrying(root, from, to, force).run();
}

}  // namespace grader
