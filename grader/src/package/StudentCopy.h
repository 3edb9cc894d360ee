#pragma once

#include <string>
#include <vector>

#include "package/CourseFiles.h"

namespace grader {

/// Which students: those of a course under way may not have everything yet, and have seen some
/// solutions.
struct StudentCopyWish {
    std::string upto;                        ///< the last assignment they get; empty: all
    std::vector<std::string> withSolutions;  ///< assignments whose solved files they get
};

/// The course as students get it: without what .gitattributes calls `instructors`, with what is in
/// students/ laid over it, its README listing the assignments, and links to pages that it lacks as
/// plain words. Throws Error for an assignment that is not known or not in the copy, for a file in
/// the copy that gives a solution away or that cannot be searched for one, and where `root` is such
/// a copy itself.
CourseFiles studentCopy(const fs::path& root, const StudentCopyWish& wish);

/// Pages of such a copy that name assignments of the course which are not in it, a sentence each.
std::vector<std::string> namesOfWhatIsLeftOut(const fs::path& root, const CourseFiles& copy);

}  // namespace grader
