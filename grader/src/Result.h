#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "Comparison.h"
#include "Diagnostics.h"
#include "Manifest.h"
#include "compare/FrameScore.h"
#include "compare/Picture.h"
#include "subject/Evidence.h"
#include "subject/Status.h"

namespace grader {

using judge::Status;

/// The pictures of a frame and the numbers behind its score.
struct FramePictures {
    Picture submission, reference, difference;
    FrameScore score;
};

/// What one feature of a frame earned, see FORMAT.md.
struct FeatureResult {
    std::string id, title;
    double points = 0, maxPoints = 0;
    std::string message;        ///< one sentence: how near, in which part of the picture
    Picture mask;               ///< white where the feature shows; empty without pictures
    std::string maskPath = {};  ///< relative to the report, set once it is written
};

/// A known mistake that explains what a task lost.
struct Recognised {
    std::vector<std::string> mistakes;  ///< ids; several when they cannot be told apart
    std::string says;                   ///< to the student
    std::string section;                ///< of the notes, to read again
};

struct CheckResult {
    std::string id;    ///< "RotateUp.KeepsTheTarget", or the frame's id
    std::string kind;  ///< "test", "frame", "manual"
    std::string task;
    std::string title;
    Status status = Status::graderError;
    double points = 0, maxPoints = 0;
    std::string message;  ///< one sentence on what was lost; empty for a full check
    std::string hint;
    std::vector<std::string> todos;         ///< unfilled regions that were reached
    bool hidden = false;                    ///< a test that students do not have
    std::string visibility = kVisible;      ///< when a learning platform shows it
    std::vector<judge::Evidence> evidence;  ///< what the subject answered
    std::optional<Comparison> comparison;
    std::vector<FeatureResult> features;  ///< of a frame whose points belong to features
    std::optional<FramePictures> pictures;
    std::map<std::string, std::string> imagePaths;  ///< set once the pictures are written

    bool full() const { return status == Status::pass; }
};

struct TaskResult {
    std::string id, title;
    double points = 0, maxPoints = 0;
    Status status = Status::graderError;
    std::vector<CheckResult> checks;
    std::optional<Recognised> recognised;
};

struct Environment {
    std::string grader, compiler, glm, glRenderer, glVersion, cpu, sandbox;
};

struct AssignmentResult {
    std::string assignment, title;
    std::string status = "graded";  ///< "graded", "build_error", "grader_error"
    std::uint64_t seed = 1;
    bool buildOk = false;
    std::vector<Diagnostic> diagnostics;
    std::vector<TaskResult> tasks;
    std::map<std::string, std::string> inherited;  ///< file → where it was taken from
    std::vector<std::string> ignoredFiles;
    std::vector<std::string> notices;
    Environment environment;
    std::map<std::string, double> timing;  ///< seconds

    double points() const;
    double maxPoints() const;
    double automaticPoints() const;  ///< the most that it can have before a person has looked
    bool full() const;
    bool notStarted() const;  ///< every check is not implemented
    bool graderFailed() const;
};

/// Points to a millionth: sums of thirds and sevenths would otherwise end in noise.
double rounded(double points);

/// Gives a test of a task that has so many its points: an equal share of what the frames leave, and
/// all of it or nothing.
void countTest(CheckResult& check, const Manifest& manifest, std::ptrdiff_t tests);

/// Sorts checks into the manifest's tasks and sums up. What is manual is pending.
std::vector<TaskResult> groupByTask(const Manifest& manifest, std::vector<CheckResult> checks);

/// The result document of one assignment, as grader/RESULT.md describes it.
std::string toJson(const AssignmentResult& result);

/// One document, or an array of several.
std::string toJson(const std::vector<AssignmentResult>& results);

}  // namespace grader
