#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/Html.h"
#include "report/HtmlCheck.h"

namespace grader {

namespace {

using Rows = std::vector<std::vector<double>>;

bool agrees(double expected, double got, double tolerance) {
    return std::abs(expected - got) <= tolerance;  // false for what is not a number
}

/// Whether (row, column) of `other` is there and agrees with `value`.
bool agreesAt(const Rows& other, std::size_t row, std::size_t column, double value,
              double tolerance) {
    return row < other.size() && column < other[row].size() &&
           agrees(other[row][column], value, tolerance);
}

std::string shown(double value, int decimals) {
    if (!std::isfinite(value))
        return fmt::format("{}", value);
    if (std::abs(value) >= 1e5)
        return fmt::format("{:.{}g}", value, decimals + 1);
    const std::string text = fmt::format("{:.{}f}", value, decimals);
    return text.find_first_not_of("-0.") == std::string::npos && text[0] == '-' ? text.substr(1)
                                                                                : text;
}

/// So few decimals that numbers are easily read, and so many that a wrong one looks different.
int decimalsFor(const Comparison& comparison) {
    constexpr int kMost = 8;
    int decimals = 0;
    const Rows& expected = comparison.expected;
    for (std::size_t i = 0; i < expected.size() && i < comparison.got.size(); ++i)
        for (std::size_t j = 0; j < expected[i].size() && j < comparison.got[i].size(); ++j) {
            const double right = expected[i][j], got = comparison.got[i][j];
            for (const double each : {right, got})
                if (std::isfinite(each) && each != std::round(each))
                    decimals = std::max(decimals, 3);
            while (decimals < kMost && !agrees(right, got, comparison.tolerance) &&
                   shown(right, decimals) == shown(got, decimals))
                ++decimals;
        }
    return decimals;
}

std::string matrix(const char* name, const Rows& rows, const Rows& other, double tolerance,
                   int decimals, bool mark) {
    std::string html = fmt::format(
        "<figure class=\"matrix\"><figcaption>{0}</figcaption><table aria-label=\"{0}\">\n", name);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        html += "<tr>";
        for (std::size_t j = 0; j < rows[i].size(); ++j) {
            const bool wrong = !agreesAt(other, i, j, rows[i][j], tolerance);
            html += fmt::format("<td{}>{}{}</td>", wrong && mark ? " class=\"wrong\"" : "",
                                shown(rows[i][j], decimals),
                                wrong && mark ? "<span class=\"unseen\"> wrong</span>" : "");
        }
        html += "</tr>\n";
    }
    return html + "</table></figure>\n";
}

}  // namespace

std::string comparisonOf(const Comparison& comparison) {
    const int decimals = decimalsFor(comparison);
    return fmt::format("<div class=\"comparison\"><p class=\"what\">{}</p>\n",
                       escaped(comparison.what)) +
           matrix("yours", comparison.got, comparison.expected, comparison.tolerance, decimals,
                  true) +
           matrix("expected", comparison.expected, comparison.got, comparison.tolerance, decimals,
                  false) +
           "</div>\n";
}

}  // namespace grader
