#pragma once

#include <optional>
#include <string>
#include <vector>

#include "Files.h"

namespace grader {

/// Whether two texts say the same, whatever their case. An empty one says nothing.
bool sameText(const std::string& a, const std::string& b);

/// A cell of RFC 4180, quoted where it must be, and harmless(). What a spreadsheet would take for a
/// formula gets an apostrophe in front.
std::string csvCell(std::string text, char separator = ',');

/// A table of comma-separated values (RFC 4180; also with semicolons or tabs, and with a byte order
/// mark) whose first row names the columns. Every byte of a cell that is not set stays as it was,
/// so that a platform's own file can be filled in.
class CsvTable {
public:
    /// Throws Error for a file that cannot be read, has no row, or has a quote that never ends.
    static CsvTable read(const fs::path& file);
    /// The same from text; `name` is for messages.
    static CsvTable parse(const std::string& text, std::string name);

    /// The column of this name, whatever its case.
    std::optional<std::size_t> column(const std::string& name) const;
    /// Throws Error that names the columns there are.
    std::size_t needColumn(const std::string& name) const;

    /// Rows beside the first, which names the columns.
    std::size_t rows() const { return rows_.empty() ? 0 : rows_.size() - 1; }
    const std::vector<std::string>& columns() const { return names_; }

    /// The text of a cell, without quotes and surrounding blanks; empty where the row is short.
    std::string cell(std::size_t row, std::size_t column) const;
    std::string cell(std::size_t row, const std::string& column) const;
    /// "file, line 12"
    std::string place(std::size_t row) const;

    void set(std::size_t row, std::size_t column, const std::string& value);
    std::string text() const;

private:
    struct Row {
        std::vector<std::string> raw;  ///< bytes between separators
        std::string end;               ///< of the line: "\r\n", "\n", or nothing
        std::size_t line = 1;
    };
    std::string name_, mark_;  ///< file; byte order mark
    char separator_ = ',';
    std::vector<Row> rows_;
    std::vector<std::string> names_;
};

}  // namespace grader
