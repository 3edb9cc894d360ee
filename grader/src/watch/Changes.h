#pragma once

#include <map>
#include <string>
#include <vector>

#include "Fields.h"

namespace grader {

/// Points that one check, or several of one task, earned or lost since the last time.
struct Change {
    double points = 0;     ///< above 0: earned
    std::string sentence;  ///< "now the columns have length 1", "no longer …"
    std::string message;   ///< of a check that lost: what came instead; may be empty
};

/// What every check of an assignment had earned when it could be checked last.
class Baseline {
public:
    /// Takes a result document and returns what it changed: what was earned first, the most points
    /// first. A check that could not be made, because something does not compile, keeps what it
    /// had. The first document changes nothing.
    std::vector<Change> take(const Json& result);

    double points() const;

private:
    struct Check {
        double points = 0;
        bool full = false;
    };
    std::map<std::string, Check> checks_;  ///< by id
};

/// The first check that lost something, in the order of the handout; null when none did, or when
/// nothing could be checked. One that rests on another task comes after all others.
const Json* firstLost(const Json& result);

/// The task after the one with this id that is not done, cyclic; null when all are.
const Json* nextTask(const Json& result, const std::string& after);

/// Whether something was handed in that no compiler accepts, C++ or a shader.
bool doesNotCompile(const Json& result);

}  // namespace grader
