#include "course/NewAssignment.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "Error.h"
#include "Manifest.h"

namespace grader {

namespace {

constexpr const char* kTemplateId = "00-skeleton";
constexpr const char* kTemplate = "grader/templates/assignment";

/// "12-first-steps" in its parts.
struct Names {
    std::string id;      ///< 12-first-steps
    std::string number;  ///< 12
    std::string task;    ///< first-steps

    explicit Names(const std::string& text) : id(text) {
        static const std::regex form("([0-9]{2})-([a-z][a-z0-9]*(-[a-z0-9]+)*)");
        std::smatch parts;
        if (!std::regex_match(text, parts, form))
            throw Error(
                "\"{}\" is no name for an assignment: expected two digits, a hyphen and lower-case "
                "words with hyphens between, such as 12-texture-mapping",
                text);
        number = parts[1];
        task = parts[2];
        if (number == "00")
            throw Error("{}: chapters count from 01", text);
    }

    std::string suite() const {
        Task named;
        named.id = task;
        return named.suite();
    }
    /// "First steps"
    std::string title() const {
        std::string words = std::regex_replace(task, std::regex("-"), " ");
        words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
        return words;
    }
};

void requireFree(const fs::path& root, const Names& names) {
    for (const char* tree : {"assignments", "solutions", "reference_images"})
        if (fs::exists(root / tree / names.id))
            throw Error("{} is there already: choose another name, or remove it first",
                        (root / tree / names.id).string());
    for (const std::string& each : knownAssignments(root)) {
        if (each.starts_with(names.number + "-"))
            throw Error("the number {} is that of {}: choose another", names.number, each);
        if (loadAssignment(root, each).task(names.task))
            throw Error(
                "{} has a task \"{}\", and a task's name is used once in a course: choose another "
                "name",
                each, names.task);
    }
}

/// The template's names in a text or in a file's name, exchanged for the new ones; longer ones
/// first, since they hold shorter ones.
std::string renamed(std::string text, const Names& names) {
    const std::string chapter = std::to_string(std::stoi(names.number));
    const std::pair<std::string, std::string> all[] = {
        {kTemplateId, names.id},
        {"# 00 The skeleton", "# " + names.number + " " + names.title()},
        {"The skeleton", names.title()},
        {"Skeleton", names.suite()},
        {"skeleton", names.task},
        {"chapter 0", "chapter " + chapter},
        {"\"chapter\": 0", "\"chapter\": " + chapter},
        {"\"section\": \"0.", "\"section\": \"" + chapter + "."},
    };
    // In one pass, so that a new name which holds an old one is left alone.
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const auto* found = std::find_if(std::begin(all), std::end(all), [&](const auto& each) {
            return text.compare(at, each.first.size(), each.first) == 0;
        });
        if (found == std::end(all)) {
            result += text[at++];
        } else {
            result += found->second;
            at += found->first.size();
        }
    }
    return result;
}

/// A folder that is made beside its place and then moved there; it goes away unless it is kept.
class Draft {
public:
    Draft(const fs::path& tree, const std::string& id)
        : at_(tree / ("." + id + ".new")), place_(tree / id) {
        fs::remove_all(at_);  // of one that was killed
    }
    ~Draft() {
        std::error_code ignored;
        if (!at_.empty())
            fs::remove_all(at_, ignored);
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    void write(const fs::path& from, const Names& names) const {
        for (const auto& entry : fs::recursive_directory_iterator(from))
            if (entry.is_regular_file())
                writeFile(at_ / renamed(entry.path().lexically_relative(from).string(), names),
                          renamed(readFile(entry.path()), names));
    }
    void moveToItsPlace() {
        fs::rename(at_, place_);
        at_ = place_;
    }
    void keep() { at_.clear(); }

private:
    fs::path at_;
    const fs::path place_;
};

}  // namespace

void requireSolutions(const fs::path& root) {
    if (!fs::is_directory(root / "solutions"))
        throw Error(
            "there is no {}, so this is a student's copy: assignments are made and proved where "
            "their solutions are",
            (root / "solutions").string());
}

void makeAssignment(const fs::path& root, const std::string& id) {
    const Names names(id);
    requireSolutions(root);
    if (!fs::is_directory(root / kTemplate))
        throw Error("{} is missing, which new assignments are copied from",
                    (root / kTemplate).string());
    requireFree(root, names);
    try {
        Draft solution(root / "solutions", id), assignment(root / "assignments", id);
        solution.write(root / kTemplate / "solutions" / kTemplateId, names);
        assignment.write(root / kTemplate / "assignments" / kTemplateId, names);
        solution.moveToItsPlace();
        assignment.moveToItsPlace();  // from now on the course knows it
        solution.keep();
        assignment.keep();
    } catch (const fs::filesystem_error& error) {
        throw Error("{} cannot be made, and nothing is left of it: {}", id, error.what());
    }
}

}  // namespace grader
