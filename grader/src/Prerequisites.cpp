#include "Prerequisites.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "Error.h"
#include "Regions.h"

namespace grader {

namespace {

/// A need: "rotation" of the same assignment, or "06-rotation/rotation".
struct Need {
    std::string assignment, task;
};

Need parseNeed(const std::string& text, const Manifest& manifest) {
    const auto slash = text.find('/');
    if (slash == std::string::npos)
        return {manifest.id, text};
    return {text.substr(0, slash), text.substr(slash + 1)};
}

class Mender {
public:
    Mender(const Grader& grader, const Manifest& manifest, Stage& stage, std::uint64_t seed,
           Grader::StageResult& graded, std::vector<std::string>& notices)
        : grader_(grader),
          root_(grader.tools().root),
          manifest_(manifest),
          stage_(stage),
          seed_(seed),
          graded_(graded),
          notices_(notices) {}

    void run() {
        if (!graded_.build.ok && onlyInheritedFilesAreBroken())
            replaceBrokenFiles();
        if (!graded_.build.ok)
            return;
        // Tasks that need the same are graded again together; no others, or a task that is itself
        // needed would be freed of its own mistake.
        for (const auto& [needs, tasks] : lostTasksByNeeds())
            mend(needs, tasks);
        tellWhatWasGained();
    }

private:
    bool onlyInheritedFilesAreBroken() const {
        bool any = false;
        for (const Diagnostic& each : graded_.build.diagnostics) {
            if (each.severity != "error")
                continue;
            const StagedFile* file = stage_.find(each.file);
            if (!file || file->role != Role::inherited || file->origin != "submission")
                return false;
            any = true;
        }
        return any;
    }

    void replaceBrokenFiles() {
        std::map<std::string, const Diagnostic*> broken;  // file → its first error
        for (const Diagnostic& each : graded_.build.diagnostics)
            if (each.severity == "error")
                broken.emplace(each.file, &each);
        std::map<std::string, std::string> uncompiled;  // task → why it is in no program
        for (const auto& [name, error] : broken) {
            StagedFile& file = *stage_.find(name);
            file = substituteFor(root_, manifest_, name);
            std::string lost = fmt::format("{}", fmt::join(tasksIn(manifest_, file.content), ", "));
            if (!lost.empty())
                lost = ", without your " + lost;
            notices_.push_back(
                fmt::format("the inherited file {} does not compile (line {}: {}): the {} took its "
                            "place{}",
                            name, error->line, error->message,
                            file.origin == "solutions" ? "solution's" : "starter's", lost));
            for (const std::string& task : tasksIn(manifest_, file.content))
                uncompiled[task] = fmt::format("{} does not compile: line {}: {}", name,
                                               error->line, error->message);
            for (StagedFile& other : stage_.files)
                if (other.role == Role::inherited && goesWith(manifest_, other.name, name))
                    other = substituteFor(root_, manifest_, other.name);
        }
        graded_ = grader_.gradeStage(manifest_, stage_, seed_);
        for (CheckResult& check : graded_.checks)
            if (const auto why = uncompiled.find(check.task); why != uncompiled.end()) {
                check.status = Status::buildError;
                check.points = 0;
                check.message = why->second;
                check.todos.clear();
            }
    }

    std::map<std::vector<std::string>, std::set<std::string>> lostTasksByNeeds() const {
        std::map<std::vector<std::string>, std::set<std::string>> lost;
        for (const CheckResult& check : graded_.checks)
            if (const auto& needs = manifest_.task(check.task)->needs;
                isLost(check) && !needs.empty() && !isBlank(check))
                lost[needs].insert(check.task);
        return lost;
    }

    void mend(const std::vector<std::string>& needs, const std::set<std::string>& lost) {
        Stage mended = stage_;
        std::vector<std::string> replaced;
        bool solutionsMissing = false;
        for (const std::string& text : needs) {
            const Need need = parseNeed(text, manifest_);
            if (!fs::exists(root_ / "solutions" / need.assignment))
                solutionsMissing = true;
            else if (replace(mended, need, Of::solution).value_or(false))
                replaced.push_back(text);
        }
        if (!replaced.empty()) {
            const auto blamed = thatLost(replaced);
            keepTheBetter(grader_.gradeStage(manifest_, mended, seed_), lost,
                          blamed.empty() ? replaced : blamed);
        }
        if (solutionsMissing)
            skipWhatRestsOnLostTasks(needs, lost);
    }

    /// Of needs those that lose points themselves, or may: of an earlier assignment nobody knows.
    std::vector<std::string> thatLost(const std::vector<std::string>& needs) const {
        std::vector<std::string> lost;
        for (const std::string& text : needs) {
            const Need need = parseNeed(text, manifest_);
            if (need.assignment != manifest_.id ||
                std::any_of(graded_.checks.begin(), graded_.checks.end(),
                            [&](const CheckResult& check) {
                                return check.task == need.task && isLost(check);
                            }))
                lost.push_back(text);
        }
        return lost;
    }

    /// A fault of the grader's tells nothing of the submission.
    static bool isLost(const CheckResult& check) {
        return !check.full() && check.status != Status::graderError;
    }

    /// Its own region is unfilled: no prerequisite can change that.
    static bool isBlank(const CheckResult& check) {
        return check.status == Status::notImplemented &&
               std::find(check.todos.begin(), check.todos.end(), check.task) != check.todos.end();
    }

    enum class Of { solution, starter };

    /// Puts the solution's or the starter's version of a needed task into the stage. False when it
    /// is there already; nothing when there is no place for it.
    std::optional<bool> replace(Stage& stage, const Need& need, Of whose) const {
        const bool solved = whose == Of::solution;
        std::optional<bool> changed;
        for (StagedFile& file : stage.files) {
            const bool ofNeed = need.assignment == manifest_.id
                                    ? file.role == Role::own
                                    : file.role == Role::inherited &&
                                          manifest_.inherits.at(file.name) == need.assignment;
            const fs::path there =
                root_ / (solved ? "solutions" : "assignments") / need.assignment / file.name;
            if (!ofNeed || !fs::exists(there))
                continue;
            const std::string text = solved && file.role == Role::inherited
                                         ? substituteFor(root_, manifest_, file.name).content
                                         : readFile(there);
            // With fences only the region is replaced; an inherited file is replaced as a whole.
            const auto regions = regionsOf(text);
            std::optional<std::string> better;
            if (regions.contains(need.task))
                better = withRegion(file.content, need.task, regions.at(need.task));
            const bool whole = !better && need.assignment != manifest_.id;
            if (whole)
                better = text;
            if (!better)
                continue;
            changed = changed.value_or(false) || *better != file.content;
            file.content = *better;
            if (whole)
                file.origin = solved ? "solutions" : "starter";  // nothing is the submission's
        }
        return changed;
    }

    void keepTheBetter(Grader::StageResult again, const std::set<std::string>& lost,
                       const std::vector<std::string>& replaced) {
        std::set<std::string>& gained = gainedBy_[fmt::format("{}", fmt::join(replaced, ", "))];
        for (CheckResult& check : graded_.checks)
            for (CheckResult& other : again.checks) {
                if (!lost.contains(check.task) || other.id != check.id)
                    continue;
                if (other.status == Status::graderError) {
                    if (isLost(check))
                        check = std::move(other);  // nobody knows what it would have earned
                    break;
                }
                // What a mistake is recognised by must not be blurred by one in what it needs;
                // checks that lost nothing are evidence, too.
                check.evidence = other.evidence;
                if (!isLost(check))
                    break;
                if (other.points > check.points || other.full()) {
                    gained.insert(check.task);
                    check = std::move(other);
                }
                break;
            }
    }

    void tellWhatWasGained() {
        for (const auto& [replaced, tasks] : gainedBy_)
            if (!tasks.empty())
                notices_.push_back(fmt::format(
                    "{} {} on {}, which loses points of its own: graded with the solution's, so "
                    "that nothing is charged twice",
                    fmt::join(tasks, ", "), tasks.size() == 1 ? "rests" : "rest", replaced));
    }

    void skipWhatRestsOnLostTasks(const std::vector<std::string>& needs,
                                  const std::set<std::string>& lost) {
        for (const std::string& text : needs) {
            const Need need = parseNeed(text, manifest_);
            if (holds(need))
                continue;
            const auto rests = checksThatRestOn(need);
            for (CheckResult& check : graded_.checks)
                if (lost.contains(check.task) && isLost(check) && check.points == 0 &&
                    check.status != Status::notImplemented &&
                    (!rests || rests->contains(check.id))) {
                    check.status = Status::skipped;
                    check.message =
                        "rests on " + text + ", which loses points itself: mend that first";
                }
        }
    }

    /// The checks that come across a task when it is unfilled; nothing where that cannot be tried.
    std::optional<std::set<std::string>> checksThatRestOn(const Need& need) const {
        Stage blank = stage_;
        const auto changed = replace(blank, need, Of::starter);
        if (!changed)
            return std::nullopt;
        const Grader::StageResult graded =
            *changed ? grader_.gradeStage(manifest_, blank, seed_) : graded_;
        if (!graded.build.ok)
            return std::nullopt;
        std::set<std::string> checks;
        for (const CheckResult& check : graded.checks)
            if (std::count(check.todos.begin(), check.todos.end(), need.task) > 0)
                checks.insert(check.id);
        return checks;
    }

    /// Whether a needed task earns all its points with the file that is in the stage.
    bool holds(const Need& need) const {
        std::vector<CheckResult> checks;
        if (need.assignment == manifest_.id)
            checks = graded_.checks;
        else {
            const Manifest other = loadAssignment(root_, need.assignment);
            Stage stage = grader_.stageOf(other, "assignments");
            for (StagedFile& file : stage.files)
                if (const StagedFile* ours = stage_.find(file.name);
                    ours && ours->role == Role::inherited)
                    file.content = ours->content;
            checks = grader_.gradeStage(other, stage, seed_).checks;
        }
        return std::all_of(checks.begin(), checks.end(), [&](const CheckResult& check) {
            return check.task != need.task || !isLost(check);
        });
    }

    const Grader& grader_;
    const fs::path& root_;
    const Manifest& manifest_;
    Stage& stage_;
    std::uint64_t seed_;
    Grader::StageResult& graded_;
    std::vector<std::string>& notices_;
    std::map<std::string, std::set<std::string>> gainedBy_;  ///< tasks, by what was replaced
};

}  // namespace

void mendPrerequisites(const Grader& grader, const Manifest& manifest, Stage& stage,
                       std::uint64_t seed, Grader::StageResult& graded,
                       std::vector<std::string>& notices) {
    Mender(grader, manifest, stage, seed, graded, notices).run();
}

}  // namespace grader
