#pragma once

#include "Grade.h"

namespace grader {

/// One error, one charge.
///
/// A task that `needs` another was graded with the student's own version of it. When it lost
/// points, it is graded again with the solution's, and each of its checks keeps the better result.
/// Where there are no solutions, checks that lost are `skipped` if the needed task itself does not
/// hold and they use it, which shows when it is emptied; others stay as they are. The same is done
/// for an inherited file that does not compile. `graded` is changed in place, `stage` only where
/// another file had to be taken, and what was done is said in `notices`.
void mendPrerequisites(const Grader& grader, const Manifest& manifest, Stage& stage,
                       std::uint64_t seed, Grader::StageResult& graded,
                       std::vector<std::string>& notices);

}  // namespace grader
