#pragma once

#include <memory>
#include <string>
#include <vector>

#include "Fields.h"

namespace grader {

/// What marks and overview need of a result document: the documents of thousands would fill the
/// memory.
struct Essence {
    struct Task {
        std::string id;
        double points = 0;
        std::string recognised;  ///< the sentence on a known mistake; empty for none
    };
    struct Check {
        std::string id, title, status;
        double points = 0, maxPoints = 0;
        std::string message;  ///< of tampering alone
        std::string picture;  ///< the submission's, relative to its report; empty for none
    };
    std::vector<Task> tasks;
    std::vector<Check> checks;
};

/// Null for the document of what was refused, which has no tasks.
std::shared_ptr<const Essence> essenceOf(const Json& document);

}  // namespace grader
