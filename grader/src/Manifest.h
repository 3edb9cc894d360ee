#pragma once

#include <map>
#include <string>
#include <vector>

#include "Files.h"

namespace grader {

/// A task, a frame, an assignment: assignment.json as the grader knows it. The fields are
/// explained in assignments/FORMAT.md.
struct Task {
    std::string id, title, hint;
    double points = 0;
    std::vector<std::string> needs;  ///< "task" or "NN-name/task"
    bool manual = false;             ///< a person judges it: no test, no region

    /// The test suite of the task: rotate-up → RotateUp.
    std::string suite() const;
};

/// What a frame shows, and what that is worth.
struct Feature {
    std::string id, title;
    double points = 0;
    std::string without;  ///< the mistake that a picture without the feature is drawn with
};

struct Frame {
    std::string id, title;
    std::string task;
    double points = 0;  ///< of the whole picture, or of all features together
    std::vector<Feature> features;
    int width = 0, height = 0;  ///< pixels
    double tolerance = 0.0005;  ///< share of pixels that may differ
};

struct AssignmentLimits {
    int buildSeconds = 20;
    double callSeconds = 2;
    double frameSeconds = 4;
    int memoryMib = 1024;
    int outputKib = 64;
};

inline constexpr const char *kVisible = "visible", *kAfterDueDate = "after_due_date",
                            *kHidden = "hidden";

struct Manifest {
    static constexpr int kFormat = 1;

    std::string id, title, summary;
    int chapter = 0;
    fs::path folder;
    std::vector<std::string> submit;              ///< file names
    std::map<std::string, std::string> inherits;  ///< file name → assignment
    AssignmentLimits limits;
    std::vector<Task> tasks;
    std::vector<Frame> frames;
    std::vector<std::string> starterPasses;  ///< checks that the starter may pass
    /// Check id → when a learning platform shows it: kVisible, kAfterDueDate, kHidden.
    std::map<std::string, std::string> visibility;

    const Task* task(const std::string& taskId) const;
    std::vector<Task> automaticTasks() const;  ///< those that are not manual
    double framePoints(const std::string& taskId) const;
    std::string visibilityOf(const std::string& checkId) const;  ///< kVisible where none is given

    /// Throws Error for anything that FORMAT.md does not allow.
    static Manifest load(const fs::path& folder);
    /// The same from the text of folder/assignment.json.
    static Manifest parse(const std::string& text, const fs::path& folder);
};

/// Ids of all assignments below `root`/assignments, in order. Throws Error when there is none.
/// A folder whose manifest has another id is left out, and named on standard error once: it is a
/// copy, or the id is a slip.
std::vector<std::string> knownAssignments(const fs::path& root);

/// The manifest of one of them; an unknown id is refused with the list of known ones.
Manifest loadAssignment(const fs::path& root, const std::string& id);

}  // namespace grader
