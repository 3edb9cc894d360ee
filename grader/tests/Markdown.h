#pragma once

#include <string>
#include <vector>

#include "Files.h"

namespace lab {

/// A command that a page tells its reader to type.
struct Command {
    std::string text;     ///< one line: continued ones are joined, comments taken off
    int line = 0;         ///< of the page, counted from 1
    bool inText = false;  ///< `in the text`, and perhaps only named; else of a fenced block
    int block = 0;        ///< which fenced block of the page it belongs to, counted from 1
};

/// Commands of a page: the lines of its fenced blocks without a language or with sh, bash or
/// console, and code within the text that begins with ./grade or ./test, or calls ctest, cmake,
/// ninja or docker with an argument. A line with && is two.
std::vector<Command> commandsIn(const std::string& markdown);

/// A link or a picture.
struct Link {
    std::string target;
    int line = 0;
};

/// Links and pictures outside of code that lead to a file or to a heading; those to other machines
/// are left out.
std::vector<Link> linksIn(const std::string& markdown);

/// The anchors of its headings, as GitHub makes them: "Marks for a platform" →
/// marks-for-a-platform.
std::vector<std::string> anchorsOf(const std::string& markdown);

}  // namespace lab
