#pragma once

#include <string>

/// What a benchmark appends to a file, so that it must be compiled: of an edited comment the grader
/// knows that it changes nothing.
inline std::string editOf(const std::string& file, int number) {
    const std::string digits = std::to_string(number);
    return file.ends_with(".cpp") ? "extern const int edit_" + digits + ";\n"
                                  : "// edit " + digits + "\n";
}
