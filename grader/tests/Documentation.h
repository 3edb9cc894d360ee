#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "CourseCopy.h"
#include "Fields.h"
#include "Markdown.h"

namespace lab {

/// What is promised in Markdown pages, tried out. Every finding names page and line.
///
/// A command is run in a copy of the checkout, once, after the names in it (SUBMISSIONS, OUT, …)
/// have become those of documentation.json; it must end with exit code 0 or 1. One that this file
/// lists under "not_run" is looked at only: each option that a ./grade command uses is in its
/// --help, a target is one that Ninja knows, a script exists. So is `code in the text` that ends
/// with "…", or that lacks what the command requires: it names the command and is none. Anything
/// else is a finding, so that no page can promise what nothing tries.
class Documentation {
public:
    /// `copy` must outlive this. Throws Error when documentation.json is not as it should be.
    explicit Documentation(const CourseCopy& copy);

    /// Throws Error when what documentation.json prepares fails.
    std::vector<std::string> tryCommands(const std::string& page, const std::string& markdown);
    std::vector<std::string> tryLinks(const std::string& page, const std::string& markdown) const;

    /// Entries of "not_run" and "words" that no page needs any more.
    std::vector<std::string> unusedEntries() const;

private:
    /// Why it is wrong; empty when it is right.
    std::string tryCommand(const Command& command, std::string& folder);
    std::string runOnce(const std::string& line, const std::string& folder, bool mayBeMention);
    std::string lookAt(const std::string& command);
    std::string lookAtGrade(const std::string& command);
    void prepare();
    std::string withWords(std::string text);

    struct Entry {
        std::string begins, why;
        bool used = false;
    };

    const CourseCopy& copy_;
    std::vector<Entry> notRun_;
    std::vector<std::string> prepare_;  ///< lines to run before names in commands mean something
    std::map<std::string, std::string> words_;
    std::set<std::string> usedWords_;
    std::map<std::string, std::string> tried_;  ///< folder and line → what was wrong
    std::map<std::string, std::string> help_;   ///< subcommand → its --help
};

/// All Markdown pages below the top of a checkout, but for those of packages from elsewhere and of
/// the template of an assignment, whose names stand for others.
std::vector<std::string> pagesOf(const grader::fs::path& root);

}  // namespace lab
