#pragma once

#include <string>
#include <vector>

namespace grader {

/// A vector or matrix that a test compared and found wrong.
struct Comparison {
    std::string what;                                ///< "rotation(50, (1, 2, 3))"
    std::vector<std::vector<double>> expected, got;  ///< by rows; a vector is one column
    double tolerance = 0;                            ///< largest difference that still agrees
};

}  // namespace grader
