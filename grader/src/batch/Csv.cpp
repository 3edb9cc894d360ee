#include "batch/Csv.h"

#include <algorithm>
#include <cstring>

#include "Error.h"
#include "report/PlainText.h"

namespace grader {

namespace {

constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";

std::string trimmed(const std::string& text) {
    const auto from = text.find_first_not_of(" \t");
    return from == std::string::npos ? ""
                                     : text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

/// What a cell means: quotes around it taken away, doubled ones inside made single.
std::string valueOf(const std::string& raw) {
    const std::string text = trimmed(raw);
    if (text.size() < 2 || text.front() != '"' || text.back() != '"')
        return text;
    std::string value;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        value += text[i];
        if (text[i] == '"' && text[i + 1] == '"')
            ++i;
    }
    return trimmed(value);
}

/// The one of , ; and tab that the first line has most of, outside quotes.
char separatorOf(const std::string& text) {
    const std::string kinds = ",;\t";
    std::size_t counts[3] = {};
    bool quoted = false;
    for (const char c : text) {
        if (c == '"')
            quoted = !quoted;
        if (!quoted && (c == '\n' || c == '\r'))
            break;
        if (const auto kind = kinds.find(c); !quoted && kind != std::string::npos)
            ++counts[kind];
    }
    return kinds[static_cast<std::size_t>(std::max_element(counts, counts + 3) - counts)];
}

}  // namespace

bool sameText(const std::string& a, const std::string& b) {
    return !a.empty() && lowered(a) == lowered(b);
}

std::string csvCell(std::string text, char separator) {
    text = harmless(std::move(text));
    if (const auto first = text.find_first_not_of(' ');
        first != std::string::npos && std::strchr("=+-@", text[first]))
        text.insert(text.begin(), '\'');
    if (text.find_first_of(std::string("\"") + separator) == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

CsvTable CsvTable::read(const fs::path& file) {
    return parse(readFile(file), file.string());
}

CsvTable CsvTable::parse(const std::string& all, std::string name) {
    CsvTable table;
    table.name_ = std::move(name);
    std::string text = all;
    if (text.starts_with(kByteOrderMark)) {
        table.mark_ = kByteOrderMark;
        text.erase(0, table.mark_.size());
    }
    table.separator_ = separatorOf(text);
    std::size_t line = 1, lineOfQuote = 0;
    Row row{{""}, "", 1};
    bool quoted = false;
    const auto endRow = [&](const std::string& end) {
        row.end = end;
        table.rows_.push_back(std::move(row));
        row = {{""}, "", ++line};
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            quoted = !quoted;
            lineOfQuote = line;
        }
        if (quoted || (c != table.separator_ && c != '\n' && c != '\r')) {
            row.raw.back() += c;
            line += quoted && c == '\n';
        } else if (c == table.separator_) {
            row.raw.emplace_back();
        } else if (c == '\r' && i + 1 < text.size() && text[i + 1] == '\n') {
            ++i;
            endRow("\r\n");
        } else {
            endRow(std::string(1, c));
        }
    }
    if (quoted)
        throw Error("{}, line {}: a quote is opened and never closed", table.name_, lineOfQuote);
    if (row.raw.size() > 1 || !row.raw.front().empty())
        table.rows_.push_back(std::move(row));
    if (table.rows_.empty())
        throw Error("{} is empty: expected a first line that names the columns", table.name_);
    for (const std::string& raw : table.rows_.front().raw)
        table.names_.push_back(valueOf(raw));
    return table;
}

std::optional<std::size_t> CsvTable::column(const std::string& name) const {
    for (std::size_t i = 0; i < names_.size(); ++i)
        if (lowered(names_[i]) == lowered(name))
            return i;
    return std::nullopt;
}

std::size_t CsvTable::needColumn(const std::string& name) const {
    if (const auto found = column(name))
        return *found;
    throw Error("{}: there is no column \"{}\"; the columns are {}", name_, name,
                fmt::join(names_, ", "));
}

std::string CsvTable::cell(std::size_t row, std::size_t column) const {
    const auto& cells = rows_.at(row + 1).raw;
    return column < cells.size() ? valueOf(cells[column]) : "";
}

std::string CsvTable::cell(std::size_t row, const std::string& name) const {
    const auto found = column(name);
    return found ? cell(row, *found) : "";
}

std::string CsvTable::place(std::size_t row) const {
    return fmt::format("{}, line {}", name_, rows_.at(row + 1).line);
}

void CsvTable::set(std::size_t row, std::size_t column, const std::string& value) {
    auto& cells = rows_.at(row + 1).raw;
    if (column >= cells.size())
        cells.resize(column + 1);
    cells[column] = csvCell(value, separator_);
}

std::string CsvTable::text() const {
    std::string all = mark_;
    for (const Row& row : rows_)
        all += fmt::format("{}{}", fmt::join(row.raw, std::string(1, separator_)), row.end);
    return all;
}

}  // namespace grader
