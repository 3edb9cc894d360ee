#pragma once

#include <string>
#include <vector>

#include "Files.h"
#include "batch/Similarity.h"

namespace grader {

/// Submissions of earlier batches, to be compared with those of today: each is named FOLDER/NAME.
/// Every folder is what ./grade batch wrote to its --out. Throws Error when one is not, is of
/// another assignment, or has kept nothing that can be compared.
std::vector<Print> earlierPrints(const std::vector<std::string>& folders,
                                 const std::string& assignment);

}  // namespace grader
