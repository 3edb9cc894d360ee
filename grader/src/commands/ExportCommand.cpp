#include "commands/ExportCommand.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <map>

#include "Error.h"
#include "ExitCode.h"
#include "batch/Gradebook.h"
#include "batch/Marks.h"
#include "batch/Moment.h"
#include "batch/Written.h"
#include "formats/Formats.h"
#include "report/PlainText.h"

namespace grader {

namespace {

struct Options {
    std::string folder, to, into, column, output, classroom;
};

/// The first task that waits for a person; empty when none does.
std::string pendingIn(const Mark& mark) {
    for (const TaskMark& task : mark.tasks)
        if (task.pending)
            return task.id;
    return "";
}

/// What `grade batch` wrote, read back.
struct WrittenBatch {
    fs::path folder;
    std::string assignment;
    std::vector<Mark> students;                   ///< that have a mark
    std::map<std::string, std::string> unmarked;  ///< the others, with a sentence on the reason

    explicit WrittenBatch(const fs::path& from) : folder(from) {
        const fs::path file = folder / "results.json";
        if (!fs::exists(file))
            throw Error("{} is not there: give the folder that ./grade batch --out wrote",
                        file.string());
        fromWritten(file, kGradeAgain, [&](const Json& document) {
            assignment = document.at("assignment");
            for (const Json& each : document.at("students"))
                take(markFrom(each));
        });
    }

private:
    void take(Mark mark) {
        const std::string& student = mark.student.id;
        if (const std::string pending = pendingIn(mark); !pending.empty())
            unmarked[student] = fmt::format(
                "{} has no mark yet: {} is pending, give its points in a table of --overrides",
                student, pending);
        else if (mark.sentence.empty() && mark.status != "missing")
            students.push_back(std::move(mark));
        else
            unmarked[student] = fmt::format("{} has no mark ({})", student, mark.status);
    }
};

/// A student whose points are decisions alone has no result document: nothing was handed in, or it
/// could not be graded.
Scored scoredOf(const WrittenBatch& batch, const Mark& mark) {
    const fs::path home = batch.folder / "students" / mark.submission,
                   result = home / "result.json";
    const bool graded = !mark.submission.empty() && fs::exists(result);
    std::map<std::string, double> tasks;
    for (const TaskMark& task : mark.tasks)
        tasks[task.id] = task.points;
    return {mark.student.id, mark.points,
            mark.maxPoints,  std::move(tasks),
            mark.remarks(),  graded ? resultIn(result) : Json{{"assignment", batch.assignment}},
            home / "report"};
}

/// What each task earned, and what people and the deadline did.
std::string feedbackFor(const Mark& mark) {
    std::vector<std::string> lines;
    for (const TaskMark& task : mark.tasks)
        lines.push_back(fmt::format("{}: {:g} of {:g}", task.id, task.points, task.maxPoints));
    for (std::string& each : mark.remarks())
        lines.push_back(std::move(each));
    return fmt::format("{}", fmt::join(lines, "; "));
}

std::vector<Line> linesOf(const WrittenBatch& batch) {
    std::vector<Line> lines;
    for (const Mark& each : batch.students)
        lines.push_back({each.student.id, each.student.name, each.student.email, each.points,
                         each.maxPoints, feedbackFor(each)});
    return lines;
}

std::string tableOf(const std::vector<Line>& lines) {
    std::string text = "student,name,email,points,max_points\r\n";
    for (const Line& each : lines)
        text += fmt::format("{},{},{},{:.2f},{:.2f}\r\n", csvCell(each.id), csvCell(each.name),
                            csvCell(each.email), each.points, each.maxPoints);
    return text;
}

void say(const std::vector<std::string>& sentences) {
    for (const std::string& each : sentences)
        std::cout << "Look at: " << harmless(each) << "\n";
}

void written(const fs::path& file, std::size_t marks) {
    std::cout << fmt::format("{} {} written to {}\n", marks, marks == 1 ? "mark" : "marks",
                             fs::absolute(file).string());
}

/// A table of the platform's, filled in.
void fill(const Options& options, const WrittenBatch& batch, const fs::path& file) {
    if (options.into.empty())
        throw Error("--to {} fills in a file that the platform exported: name it with --into",
                    options.to);
    const CsvTable table = CsvTable::read(options.into);
    const auto lines = linesOf(batch);
    const std::string& column = options.column.empty() ? batch.assignment : options.column;
    const Filled filled =
        options.to == "canvas" ? fillCanvas(table, column, lines) : fillMoodle(table, lines);
    writeFile(file, filled.text);
    written(file, filled.marks);
    say(filled.remarks);
}

/// A file for each student.
void writeEach(const WrittenBatch& batch, const fs::path& out, const std::string& ending,
               const std::function<std::string(const Scored&)>& format) {
    const auto fileOf = [&](std::string student) {
        std::replace(student.begin(), student.end(), '/', '_');
        return out / (student + ending);
    };
    std::map<fs::path, std::string> owners;
    for (const Mark& each : batch.students)
        if (const auto [other, isNew] = owners.emplace(fileOf(each.student.id), each.student.id);
            !isNew)
            throw Error("{} would be the file of two students, {} and {}: export another form",
                        harmless(other->first.string()), harmless(other->second),
                        harmless(each.student.id));
    for (const auto& [student, reason] : batch.unmarked)
        if (!owners.contains(fileOf(student)))
            fs::remove(fileOf(student));  // of an earlier export
    for (const Mark& each : batch.students)
        writeFile(fileOf(each.student.id), format(scoredOf(batch, each)));
    written(out, batch.students.size());
}

void exportBatch(const Options& options) {
    const WrittenBatch batch(options.folder);
    const auto target = [&](const std::string& name) {
        return options.output.empty() ? batch.folder / "export" / name : fs::path(options.output);
    };
    if (options.to == "canvas" || options.to == "moodle") {
        fill(options, batch, target(options.to + ".csv"));
    } else if (options.to == "gradescope") {
        writeEach(batch, target("gradescope"), ".json", gradescopeResult);
    } else if (options.to == "prairielearn") {
        writeEach(batch, target("prairielearn"), ".json", prairieLearnResult);
    } else if (options.to == "classroom50") {
        const Classroom classroom{options.classroom,
                                  toString(std::chrono::time_point_cast<std::chrono::seconds>(
                                      std::chrono::system_clock::now()))};
        writeEach(batch, target("classroom50"), ".json",
                  [&](const Scored& scored) { return classroom50Result(scored, classroom); });
    } else if (options.to == "autolab") {
        writeEach(batch, target("autolab"), ".txt", autolabLine);
    } else if (options.to == "junit") {
        std::vector<Scored> all;
        for (const Mark& each : batch.students)
            all.push_back(scoredOf(batch, each));
        writeFile(target("junit.xml"), junitXml(batch.assignment, all));
        written(target("junit.xml"), all.size());
    } else {
        writeFile(target("marks.csv"), tableOf(linesOf(batch)));
        written(target("marks.csv"), batch.students.size());
    }
    for (const auto& [student, reason] : batch.unmarked)
        say({reason});
}

}  // namespace

void addExportCommand(CLI::App& app, int& exitCode) {
    static Options options;
    CLI::App* command =
        app.add_subcommand("export", "turn what a batch found into a learning platform's own form");
    command->add_option("folder", options.folder, "what ./grade batch --out wrote")->required();
    command->add_option("--to", options.to, "the platform, or a form that many read")
        ->required()
        ->check(CLI::IsMember({"canvas", "moodle", "gradescope", "prairielearn", "classroom50",
                               "autolab", "junit", "csv"}));
    command->add_option("--into", options.into,
                        "the gradebook of Canvas or the worksheet of Moodle; a copy is filled in");
    command->add_option("--column", options.column,
                        "column of Canvas's gradebook; default the one named like the assignment");
    command->add_option("--classroom", options.classroom, "name of the class, for classroom50");
    command->add_option("--output", options.output,
                        "file or folder to write; default below FOLDER/export");
    command->callback([&exitCode] {
        exportBatch(options);
        exitCode = kFullMarks;
    });
}

}  // namespace grader
