#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "Fields.h"
#include "Files.h"
#include "Process.h"

/// A submission made for one test, graded by the program that students run.
namespace lab {

using namespace grader;

/// The grader's answer.
struct Graded {
    int exitCode = -1;
    std::string text;  ///< all that it printed
    Json document;     ///< null when it printed none

    double points() const { return document.at("points"); }
    const Json& task(const std::string& id) const;
    const Json& check(const std::string& id) const;
    std::string status(const std::string& checkId) const { return check(checkId).at("status"); }
    std::string message(const std::string& checkId) const { return check(checkId).at("message"); }
    /// Ids of the tasks that lost points.
    std::vector<std::string> losses() const;
    bool notes(const std::string& part) const;
};

class Submission {
public:
    /// A folder per assignment, all solved.
    Submission();

    fs::path folder() const { return work_.path() / "submission"; }
    fs::path file(const std::string& name) const { return folder() / name; }

    void write(const std::string& name, const std::string& content);
    std::string read(const std::string& name) const { return readFile(file(name)); }
    /// Puts `body` into a TODO region.
    void solve(const std::string& name, const std::string& region, const std::string& body);
    /// Replaces every occurrence; fails the test when there is none.
    void replace(const std::string& name, const std::string& from, const std::string& to);

    /// `grader ASSIGNMENT --submission … --json - MORE`.
    Graded grade(const std::string& assignment, std::vector<std::string> more = {}) const;

private:
    WorkFolder work_;
};

fs::path root();

/// Runs the grader with these arguments; `document` is set when the output is JSON.
Graded runGrader(const std::vector<std::string>& arguments);

}  // namespace lab
