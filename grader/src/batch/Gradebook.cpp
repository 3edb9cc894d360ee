#include "batch/Gradebook.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "Error.h"
#include "report/PlainText.h"

namespace grader {

namespace {

std::string shown(double points) {
    return fmt::format("{:.2f}", points);
}

/// How many points a platform counts; 0 where it does not say. Some write a decimal comma.
double pointsIn(std::string text, const std::string& where) {
    if (text.empty() || text == "-")
        return 0;
    std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failed != std::errc() || end != text.data() + text.size())
        throw Error("{}: expected a number of points, found \"{}\"", where, text);
    return value;
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

/// The rows in which any of the columns holds any of the keys.
std::set<std::size_t> rowsWith(const CsvTable& table, const std::vector<std::string>& columns,
                               const std::vector<std::string>& keys) {
    std::set<std::size_t> found;
    for (std::size_t row = 0; row < table.rows(); ++row)
        for (const std::string& column : columns)
            for (const std::string& key : keys)
                if (sameText(table.cell(row, column), key))
                    found.insert(row);
    return found;
}

/// As a spreadsheet counts rows, where the first one names the columns.
std::size_t numberOf(std::size_t row) {
    return row + 2;
}

std::string nameOf(const Line& line) {
    return line.name.empty() ? line.id : line.name + " (" + line.id + ")";
}

/// The row of each line, by `find`; none for lines that are nowhere, nor for those that fit several
/// rows or share one: nobody knows whose it is.
template <class Find>
std::vector<std::optional<std::size_t>> rowsOf(const std::vector<Line>& lines, const char* nowhere,
                                               std::vector<std::string>& remarks, Find find) {
    std::vector<std::optional<std::size_t>> rows;
    std::map<std::size_t, std::size_t> claims;
    for (const Line& line : lines) {
        const std::set<std::size_t> found = find(line);
        rows.emplace_back();
        if (found.size() == 1)
            ++claims[rows.back().emplace(*found.begin())];
        else if (found.empty())
            remarks.push_back(nameOf(line) + nowhere);
        else
            remarks.push_back(
                fmt::format("{} fits several rows, {} and {}: they are left as they are",
                            nameOf(line), numberOf(*found.begin()), numberOf(*found.rbegin())));
    }
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (rows[i] && claims[*rows[i]] > 1) {
            remarks.push_back(
                fmt::format("{} fits row {}, and so does another: it is left as it is",
                            nameOf(lines[i]), numberOf(*rows[i])));
            rows[i].reset();
        }
    return rows;
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
            possible = pointsIn(table.cell(row, column), "Points Possible");
    Scale scale{"Canvas", filled.remarks};
    const auto rows = rowsOf(lines, " is not in the gradebook", filled.remarks, [&](const Line& l) {
        return rowsWith(table, {"ID", "SIS User ID", "SIS Login ID"}, {l.id, l.email});
    });
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (rows[i]) {
            table.set(*rows[i], column, scale(lines[i], possible));
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
    const auto rows = rowsOf(lines, " is not in the worksheet", filled.remarks, [&](const Line& l) {
        const auto found = rowsWith(table, {"Identifier", "Email address", "ID number"},
                                    {"Participant " + l.id, l.id, l.email});
        return found.empty() ? rowsWith(table, {"Full name"}, {l.name}) : found;
    });
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!rows[i])
            continue;
        const std::size_t row = *rows[i];
        if (lowered(table.cell(row, "Grade can be changed")) == "no") {
            filled.remarks.push_back(nameOf(lines[i]) +
                                     ": Moodle says that the grade cannot be changed");
            continue;
        }
        table.set(row, grade,
                  scale(lines[i], pointsIn(table.cell(row, "Maximum Grade"), "Maximum Grade")));
        if (feedback)
            table.set(row, *feedback, lines[i].feedback);
        ++filled.marks;
    }
    filled.text = table.text();
    return filled;
}

}  // namespace grader
