#pragma once

#include <string>

namespace grader {

/// What is wrong with the course, printed as it is found, each with what mends it.
class Findings {
public:
    /// `mend`: a command to type, or a sentence on what to edit.
    void add(const std::string& what, const std::string& mend);
    int count() const { return count_; }

private:
    int count_ = 0;
};

}  // namespace grader
