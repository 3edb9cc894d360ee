#include "batch/Roster.h"

#include <algorithm>
#include <map>
#include <regex>

#include "Error.h"
#include "batch/Csv.h"
#include "report/PlainText.h"

namespace grader {

namespace {

void readExtension(const std::string& text, const std::string& place, Student& student) {
    static const std::regex kSpan(R"((\d{1,4}) ?(d|h))");
    std::smatch part;
    if (text.empty())
        return;
    if (std::regex_match(text, part, kSpan))
        student.extension =
            std::chrono::hours(std::stoi(part[1].str()) * (part[2] == "d" ? 24 : 1));
    else
        student.due = parseMoment(text, place + ": extension (or give days or hours, like 2d)");
}

/// The students of the roster that an owner could be: by id or email; else by name.
std::vector<const Student*> studentsCalled(const Owner& owner, const std::vector<Student>& roster) {
    std::vector<const Student*> found;
    for (const Student& each : roster)
        if (sameText(each.id, owner.id) || sameText(each.email, owner.email))
            found.push_back(&each);
    if (found.empty())
        for (const Student& each : roster)
            if (sameText(each.name, owner.name))
                found.push_back(&each);
    return found;
}

std::vector<const Student*> studentsOfGroup(const std::string& name,
                                            const std::vector<Student>& roster) {
    std::vector<const Student*> found;
    for (const Student& each : roster)
        if (sameText(each.group, name))
            found.push_back(&each);
    return found;
}

/// Whose a submission is, as far as it says so itself.
std::vector<Owner> ownersOf(const Entrant& entrant) {
    if (!entrant.owners.empty())
        return entrant.owners;
    return {{entrant.name, entrant.name, entrant.name}};
}

class Enrolment {
public:
    Enrolment(const Intake& intake, const std::vector<Student>* roster) {
        if (roster)
            for (const Student& each : *roster)
                participants_[each.id] = {each, true};
        for (const Entrant& entrant : intake.entrants)
            for (const Owner& owner : ownersOf(entrant))
                give(entrant, owner, roster);
    }

    ClassList list() {
        for (auto& [id, participant] : participants_) {
            orderAttempts(participant);
            list_.participants.push_back(std::move(participant));
        }
        return std::move(list_);
    }

private:
    void give(const Entrant& entrant, const Owner& owner, const std::vector<Student>* roster) {
        auto found = roster ? studentsCalled(owner, *roster) : std::vector<const Student*>{};
        if (found.size() > 1) {
            std::vector<std::string> ids;
            for (const Student* each : found)
                ids.push_back(each->id);
            list_.unclear.push_back(fmt::format("{} could be the submission of {}", entrant.name,
                                                fmt::join(ids, " or of ")));
            return;
        }
        if (found.empty() && roster)
            found = studentsOfGroup(owner.id, *roster);
        for (const Student* each : found) {
            auto& attempts = participants_.at(each->id).attempts;
            if (attempts.empty() || attempts.back() != &entrant)  // named twice in one group
                attempts.push_back(&entrant);
        }
        if (!found.empty())
            return;
        // Nobody's that is known: it stands for itself.
        const std::string& id = !owner.id.empty()      ? owner.id
                                : !owner.email.empty() ? owner.email
                                                       : entrant.name;
        Participant& participant = participants_[id];
        participant.student.id = id;
        if (owner.id != owner.name || owner.name != entrant.name) {
            participant.student.name = owner.name.empty() ? entrant.name : owner.name;
            participant.student.email = owner.email;
        }
        participant.attempts.push_back(&entrant);
    }

    static void orderAttempts(Participant& participant) {
        auto& attempts = participant.attempts;
        if (attempts.size() < 2)
            return;
        const bool timed = std::all_of(attempts.begin(), attempts.end(),
                                       [](const Entrant* each) { return each->submitted; });
        if (!timed) {
            std::vector<std::string> names;
            for (const Entrant* each : attempts)
                names.push_back(each->name);
            participant.problem = fmt::format(
                "handed in as {}, and nothing says which came last: give their times with --times, "
                "or take all but one away",
                fmt::join(names, " and as "));
            return;
        }
        std::stable_sort(attempts.begin(), attempts.end(), [](const Entrant* a, const Entrant* b) {
            return *a->submitted < *b->submitted;
        });
    }

    ClassList list_;
    std::map<std::string, Participant> participants_;
};

}  // namespace

std::vector<Student> readRoster(const fs::path& file) {
    const CsvTable table = CsvTable::read(file);
    table.needColumn("id");
    std::vector<Student> roster;
    std::map<std::string, std::string> seen;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        Student student{table.cell(row, "id"),
                        table.cell(row, "name"),
                        table.cell(row, "email"),
                        table.cell(row, "section"),
                        table.cell(row, "group"),
                        {},
                        {}};
        if (student.id.empty())
            throw Error("{}: the id is missing", table.place(row));
        if (!seen.emplace(lowered(student.id), table.place(row)).second)
            throw Error("{}: the id {} is there already, in {}", table.place(row), student.id,
                        seen.at(lowered(student.id)));
        if (const std::string due = table.cell(row, "due"); !due.empty())
            student.due = parseMoment(due, table.place(row) + ": due");
        readExtension(table.cell(row, "extension"), table.place(row), student);
        roster.push_back(std::move(student));
    }
    if (roster.empty())
        throw Error("{} names no student", file.string());
    return roster;
}

ClassList whoIsWho(const Intake& intake, const std::vector<Student>* roster) {
    return Enrolment(intake, roster).list();
}

}  // namespace grader
