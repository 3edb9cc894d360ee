#include "batch/Gradebook.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <regex>

#include "Error.h"

namespace grader {

namespace {

std::string shown(double points) {
    return fmt::format("{:.2f}", points);
}

double numberIn(const std::string& text) {
    double value = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failed == std::errc() && end == text.data() + text.size() ? value : 0;
}

/// A mark as the platform counts it; says once where that is another number of points than ours.
struct Scale {
    const char* platform;
    std::vector<std::string>& remarks;
    bool said = false;

    /// `possible`: the platform's points, 0 where it names none.
    std::string operator()(const Line& line, double possible) {
        if (possible <= 0 || std::abs(possible - line.maxPoints) < 1e-9)
            return shown(line.points);
        if (!said)
            remarks.push_back(
                fmt::format("marks are scaled from {:g} to the {:g} points that {} counts",
                            line.maxPoints, possible, platform));
        said = true;
        return shown(line.points * possible / line.maxPoints);
    }
};

/// The row in which any of the columns holds any of the keys; nothing when none or several do.
std::optional<std::size_t> rowWith(const CsvTable& table, const std::vector<std::string>& columns,
                                   const std::vector<std::string>& keys) {
    std::optional<std::size_t> found;
    for (std::size_t row = 0; row < table.rows(); ++row)
        for (const std::string& column : columns)
            for (const std::string& key : keys)
                if (sameText(table.cell(row, column), key)) {
                    if (found && *found != row)
                        return std::nullopt;
                    found = row;
                }
    return found;
}

std::string nameOf(const Line& line) {
    return line.name.empty() ? line.id : line.name + " (" + line.id + ")";
}

std::size_t columnLike(const CsvTable& table, const std::string& name) {
    if (const auto exact = table.column(name))
        return *exact;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < table.columns().size(); ++i)
        if (lowered(table.columns()[i]).find(lowered(name)) != std::string::npos)
            found.push_back(i);
    if (found.size() != 1)
        throw Error("{} columns have \"{}\" in their name; name one with --column: {}",
                    found.size(), name, fmt::join(table.columns(), ", "));
    return found.front();
}

}  // namespace

Filled fillCanvas(CsvTable table, const std::string& name, const std::vector<Line>& lines) {
    table.needColumn("Student");
    table.needColumn("ID");
    const std::size_t column = columnLike(table, name);
    Filled filled;
    double possible = 0;
    for (std::size_t row = 0; row < table.rows(); ++row)
        if (table.cell(row, "Student") == "Points Possible")
            possible = numberIn(table.cell(row, column));
    Scale scale{"Canvas", filled.remarks};
    for (const Line& line : lines) {
        const auto row =
            rowWith(table, {"ID", "SIS User ID", "SIS Login ID"}, {line.id, line.email});
        if (!row) {
            filled.remarks.push_back(nameOf(line) + " is not in the gradebook");
            continue;
        }
        table.set(*row, column, scale(line, possible));
        ++filled.marks;
    }
    filled.text = table.text();
    return filled;
}

Filled fillMoodle(CsvTable table, const std::vector<Line>& lines) {
    const std::size_t grade = table.needColumn("Grade");
    table.needColumn("Identifier");
    const auto feedback = table.column("Feedback comments");
    Filled filled;
    Scale scale{"Moodle", filled.remarks};
    for (const Line& line : lines) {
        auto row = rowWith(table, {"Identifier", "Email address", "ID number"},
                           {"Participant " + line.id, line.id, line.email});
        if (!row)
            row = rowWith(table, {"Full name"}, {line.name});
        if (!row) {
            filled.remarks.push_back(nameOf(line) + " is not in the worksheet");
            continue;
        }
        if (lowered(table.cell(*row, "Grade can be changed")) == "no") {
            filled.remarks.push_back(nameOf(line) +
                                     ": Moodle says that the grade cannot be changed");
            continue;
        }
        table.set(*row, grade, scale(line, numberIn(table.cell(*row, "Maximum Grade"))));
        if (feedback)
            table.set(*row, *feedback, line.feedback);
        ++filled.marks;
    }
    filled.text = table.text();
    return filled;
}

}  // namespace grader
