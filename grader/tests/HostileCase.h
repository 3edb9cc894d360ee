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
    std::vector<std::string> says;          ///< one of these must be told to the student
    std::vector<std::string> hides;         ///< must occur in nothing that the student is shown
    std::vector<std::string> escapes;       ///< must not occur as it is in the page
    std::vector<std::string> startsNoLine;  ///< of the terminal: commands to a CI system
    std::vector<std::string> ignored;       ///< must be named as not taken
    bool batch = false;  ///< graded by `grader batch`, with a seed that nobody knows
    std::string plain;   ///< why no plain process can hold it; empty: it must hold there, too
    std::string withoutLandlock;  ///< the same, where the kernel has none to close files
    fs::path folder;
};

/// All cases whose names hold `only`, by name. Throws Error that names the file and what is wrong.
std::vector<Case> readCases(const fs::path& home, const std::string& only);

/// The name that an attack uses for what it leaves behind, @LEFT@: nobody else's.
std::string leftBy(const Case& attack);

/// What surrounds the submissions: secrets that no one may find, and honest neighbours. What
/// grades them is what the machine has, or a plain process (--no-sandbox).
class World {
public:
    explicit World(bool plain);

    /// A submission: the solutions with the attack laid over them, or an archive, where the attack
    /// has made one (archive.*).
    fs::path prepare(const Case& attack, const fs::path& target) const;

    /// Texts that must occur nowhere: planted beside the submission, in a neighbour's files and in
    /// the grader's environment; and every long line of the hidden tests.
    const std::vector<std::string>& secrets() const { return secrets_; }
    /// What an attack has left, or changed, outside its own folders: in the system's, in the
    /// checkout, in the grader's working folder, among its neighbours.
    std::vector<std::string> tracesOf(const Case& attack) const;
    /// A submission that is all right, and one with a mistake that earns parts of its points.
    fs::path honest() const { return honest_.folder(); }
    fs::path halfRight() const { return halfRight_.folder(); }
    fs::path folder() const { return work_.path(); }
    bool plain() const { return plain_; }

private:
    std::string filled(std::string text, const Case& attack) const;
    fs::path githubEnv() const { return folder() / "github.env"; }

    const bool plain_;
    lab::WorkFolder work_;
    lab::Submission honest_, halfRight_;
    std::vector<std::string> secrets_;
};

/// All that a student could be shown of a grading.
struct Shown {
    std::string terminal, result, page;
    bool refused = false;  ///< as a whole: then there is no page
    std::string failure;   ///< of the grader itself; empty when there is none
    double seconds = 0;
};

/// Grades a folder or archive by the command that students run.
Shown gradeAlone(const fs::path& submission, const std::string& assignment, const World& world,
                 bool withPage);

/// Grades a class of one, as an instructor does, with a seed that nobody knows.
Shown gradeInBatch(const fs::path& submission, const std::string& assignment, const World& world);

/// What a student could read there, in the letters that it stands for: without the escapes of JSON
/// and HTML, and with one blank for each space between words.
std::string readable(const Shown& shown);
std::string withSingleBlanks(const std::string& text);

/// What became of a submission.
struct Outcome {
    std::string verdict;
    double points = 0;
    double seconds = 0;
    std::vector<std::string> faults;  ///< in which it is not what was expected
    Json document;                    ///< without its times; null where it was not graded
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
