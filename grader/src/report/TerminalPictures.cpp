#include "report/TerminalPictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace grader {

namespace {

constexpr int kGap = 2;  // columns between the pictures

using Colour = std::array<int, 3>;

/// The mean of what cell (column, row) of a grid of columns x rows covers.
Colour meanOf(const Picture& picture, int column, int row, int columns, int rows) {
    const int left = column * picture.width / columns, top = row * picture.height / rows;
    const int right = std::max(left + 1, (column + 1) * picture.width / columns);
    const int bottom = std::max(top + 1, (row + 1) * picture.height / rows);
    Colour sum{};
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += picture.pixel(x, y)[c];
    for (int& each : sum)
        each /= (right - left) * (bottom - top);
    return sum;
}

/// One line of one picture: rows 2 * line and 2 * line + 1 of the grid.
std::string lineOf(const Picture& picture, int line, int columns, int rows) {
    std::string text;
    Colour ink{-1, -1, -1}, paper = ink;
    for (int column = 0; column < columns; ++column) {
        const Colour upper = meanOf(picture, column, 2 * line, columns, rows);
        const Colour lower = meanOf(picture, column, 2 * line + 1, columns, rows);
        if (upper != ink)
            text += fmt::format("\033[38;2;{};{};{}m", upper[0], upper[1], upper[2]);
        if (lower != paper)
            text += fmt::format("\033[48;2;{};{};{}m", lower[0], lower[1], lower[2]);
        ink = upper, paper = lower;
        text += "▀";
    }
    return text + "\033[0m";
}

}  // namespace

std::string previewOf(const Picture& yours, const Picture& reference, int columns, int indent) {
    const double shape = double(reference.height) / reference.width;
    const int lines = std::max(1, static_cast<int>(std::lround(columns * shape / 2)));
    const std::string margin(static_cast<std::size_t>(indent), ' ');
    std::string text = fmt::format("{}{:<{}}{}\n", margin, "yours", columns + kGap, "reference");
    for (int line = 0; line < lines; ++line)
        text += margin + lineOf(yours, line, columns, 2 * lines) + std::string(kGap, ' ') +
                lineOf(reference, line, columns, 2 * lines) + "\n";
    return text;
}

std::string whyNoPreviews(bool isTerminal, const char* colorterm) {
    if (!isTerminal)
        return "No pictures are shown, because the output does not go to a terminal.";
    const std::string_view colours = colorterm ? colorterm : "";
    if (colours != "truecolor" && colours != "24bit")
        return "No pictures are shown, because this terminal does not say that it has 24-bit "
               "colour (COLORTERM=truecolor).";
    return "";
}

}  // namespace grader
