#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "Fields.h"

namespace grader {

/// A text that is kept as long as the program runs, once however often it is asked for.
std::string_view interned(const std::string& text);

/// What marks and overview need of a result document: the documents of thousands would fill the
/// memory. Nearly all texts are those of many; each is a literal, or interned().
struct Essence {
    struct Task {
        std::string_view id;
        double points = 0;
        std::string_view recognised;  ///< the sentence on a known mistake; empty for none
    };
    struct Check {
        std::string_view id, title, status;
        double points = 0, maxPoints = 0;
        std::string_view message;  ///< of tampering alone
        std::string_view picture;  ///< the submission's, relative to its report; empty for none
    };
    std::vector<Task> tasks;
    std::vector<Check> checks;
};

/// Null for the document of what was refused, which has no tasks.
std::shared_ptr<const Essence> essenceOf(const Json& document);

}  // namespace grader
