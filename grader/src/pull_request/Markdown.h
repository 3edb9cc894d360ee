#pragma once

#include <string>

namespace grader {

/// A student's text in GitHub's Markdown and logs. It can neither leave its place nor become
/// markup.

/// Shown as it is, on one line of at most `most` columns.
std::string escapedMarkdown(const std::string& text, std::size_t most = 400);

/// A block of code that its content cannot close; at most 4000 columns.
std::string fencedMarkdown(const std::string& text);

/// A path or name between backticks, on one line.
std::string codeMarkdown(const std::string& text);

/// The data of a workflow command, and the value of one of its properties (docs.github.com,
/// "Workflow commands for GitHub Actions"): on one line, at most 1000 columns.
std::string commandData(const std::string& text);
std::string commandProperty(const std::string& text);

/// A text in which a log finds no workflow command: GitHub is told by a word that nobody can guess
/// to read none until it comes again.
std::string withoutCommands(const std::string& text);

}  // namespace grader
