#include "batch/Merge.h"

#include <cmath>
#include <set>

#include "Error.h"
#include "batch/Written.h"
#include "report/PlainText.h"

namespace grader {

namespace {

/// Students that handed nothing in are in every part; one with a submission says more.
bool saysMore(const Mark& a, const Mark& b) {
    return !a.submission.empty() && b.submission.empty();
}

void requireSame(const Mark& a, const Mark& b, const fs::path& part) {
    if (a.submission != b.submission || a.status != b.status ||
        std::abs(a.points - b.points) > 1e-6)
        throw Error(
            "{}: {} has {} with {:g} points here, and {} with {:g} points in another part: grade "
            "it again with --fresh in one of them",
            part.string(), harmless(a.student.id), a.status, a.points, b.status, b.points);
}

class Merging {
public:
    void add(const fs::path& part) {
        const fs::path file = part / "results.json";
        if (!fs::exists(file))
            throw Error("{} is not there: was ./grade batch --out {} run to its end?",
                        file.string(), part.string());
        fromWritten(file, kGradeAgain, [&](const Json& document) {
            agree(document, part);
            for (const Json& each : document.at("class"))
                class_.insert(each.get<std::string>());
            for (const Json& each : document.at("not_taken"))
                notTaken_.insert(each.get<std::string>());
            for (const Json& each : document.at("students"))
                take(markFrom(each), part);
        });
    }

    Merged merged() {
        for (const auto& [id, mark] : marks_)
            merged_.marks.push_back(mark);
        for (const std::string& id : class_) {
            merged_.classIds.push_back(id);
            if (!marks_.contains(id))
                merged_.missing.push_back(id);
        }
        merged_.notTaken.assign(notTaken_.begin(), notTaken_.end());
        return std::move(merged_);
    }

private:
    void agree(const Json& document, const fs::path& part) {
        const std::string assignment = document.at("assignment");
        const auto seed = document.at("seed").get<std::uint64_t>();
        const Json& environment = document.at("environment");
        if (merged_.assignment.empty()) {
            merged_.assignment = assignment;
            merged_.seed = seed;
            merged_.environment = environment;
        }
        if (merged_.assignment != assignment)
            throw Error("{} holds results of {}, another part of {}", part.string(), assignment,
                        merged_.assignment);
        if (merged_.seed != seed)
            throw Error(
                "{} was graded with another seed than another part: give all parts the same "
                "--seed",
                part.string());
        for (const auto& [name, value] : environment.items())
            if (merged_.environment.value(name, "") != value)
                notTaken_.insert(fmt::format(
                    "the parts were graded on different machines: {} is "
                    "{} in one and {} in another",
                    name, merged_.environment.value(name, ""), value.get<std::string>()));
    }

    void take(Mark mark, const fs::path& part) {
        const auto known = marks_.find(mark.student.id);
        if (known != marks_.end() && !saysMore(mark, known->second)) {
            if (!saysMore(known->second, mark))
                requireSame(mark, known->second, part);
            return;
        }
        const fs::path result = part / "students" / mark.submission / "result.json";
        if (!mark.submission.empty()) {
            merged_.parts[mark.submission] = part;
            if (fs::exists(result))
                mark.result = fromWritten(result, kGradeAgain, essenceOf);
        }
        marks_[mark.student.id] = std::move(mark);
    }

    Merged merged_;
    std::map<std::string, Mark> marks_;
    std::set<std::string> class_, notTaken_;
};

}  // namespace

Merged readParts(const std::vector<fs::path>& parts) {
    Merging merging;
    for (const fs::path& part : parts)
        merging.add(part);
    return merging.merged();
}

void copyFolders(const Merged& merged, const fs::path& out) {
    for (const auto& [submission, part] : merged.parts)
        for (const char* whose : {"students", "instructor"}) {
            const fs::path from = part / whose / submission, to = out / whose / submission;
            if (!fs::exists(from) || (fs::exists(to) && fs::equivalent(from, to)))
                continue;
            fs::remove_all(to);
            fs::create_directories(to.parent_path());
            fs::copy(from, to, fs::copy_options::recursive);
        }
}

}  // namespace grader
