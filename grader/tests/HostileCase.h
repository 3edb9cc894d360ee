#pragma once

#include <set>
#include <string>
#include <vector>

#include "Lab.h"

/// Submissions that attack, each in a folder grader/tests/hostile/GROUP-NAME with an expect.json.
namespace hostile {

using lab::Json;
namespace fs = lab::fs;

/// One attack, and what must become of it. docs: grader/SECURITY.md.
struct Case {
    std::string name;   ///< of its folder
    std::string about;  ///< one sentence: what is tried
    std::string assignment;
    std::set<std::string> verdicts;  ///< one of these must come out
    double mostPoints = 0;
    std::string file, region;               ///< where top.* and body.* go; empty: only make.sh
    std::string says;                       ///< must be told to the student; may be empty
    std::vector<std::string> hides;         ///< must occur in nothing that the student is shown
    std::vector<std::string> escapes;       ///< must not occur as it is in the page
    std::vector<std::string> startsNoLine;  ///< of the terminal: commands to a CI system
    std::vector<std::string> ignored;       ///< must be named as not taken
    fs::path folder;
};

/// All cases whose names hold `only`, by name. Throws Error that names the file and what is wrong.
std::vector<Case> readCases(const fs::path& home, const std::string& only);

/// What surrounds the submissions: secrets that no one may find, and honest neighbours.
class World {
public:
    World();

    /// A submission: the solutions with the attack laid over them, or an archive, where the attack
    /// has made one (archive.*).
    fs::path prepare(const Case& attack, const fs::path& target) const;

    /// Texts that must occur nowhere: planted beside the submission, in a neighbour's files and in
    /// the grader's environment; and every long line of the hidden tests.
    const std::vector<std::string>& secrets() const { return secrets_; }
    /// Whether there is nothing in its folder but what it put there, and no /tmp/left-behind.
    bool isUntouched() const;
    /// A submission that is all right, and one with a mistake that earns parts of its points.
    fs::path honest() const { return honest_.folder(); }
    fs::path halfRight() const { return halfRight_.folder(); }
    fs::path folder() const { return work_.path(); }

private:
    std::string filled(std::string text) const;

    lab::WorkFolder work_;
    lab::Submission honest_, halfRight_;
    std::vector<std::string> secrets_;
};

/// What became of a submission.
struct Outcome {
    std::string verdict;
    double points = 0;
    double seconds = 0;
    std::vector<std::string> faults;  ///< in which it is not what was expected
    Json document;                    ///< without its times
};

/// Grades an attack and compares with what was expected.
Outcome tryCase(const Case& attack, const World& world);

/// Grades the honest neighbour.
Outcome tryHonest(const std::string& assignment, const World& world);

/// What the half-right neighbour is graded in.
inline const std::string kHalfRight = "06-rotation";
Outcome tryHalfRight(const World& world);

/// Command lines of processes of submissions that are still there.
std::vector<std::string> survivors();

}  // namespace hostile
