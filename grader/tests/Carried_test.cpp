// A student's files of one assignment, carried to the next: every program takes them from there.

#include <gmock/gmock.h>

#include "CourseCopy.h"
#include "Lab.h"

namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = lab::fs;

const std::string kCamera = "assignments/08-perspective/Camera.cpp";

TEST(Carried, FilesCountInGradingAndInTheWindow) {
    const lab::CourseCopy copy;
    for (const char* name : {"Camera.h", "Camera.cpp"})
        fs::copy_file(copy.root() / "solutions/07-camera" / name,
                      copy.root() / "assignments/07-camera" / name,
                      fs::copy_options::overwrite_existing);
    const auto same = copy.sh("./grade carry 07-camera 07-camera");
    EXPECT_EQ(same.exitCode, 2);
    EXPECT_THAT(same.output, HasSubstr("the two are the same"));
    const auto carried = copy.sh("./grade carry 07-camera 08-perspective");
    ASSERT_EQ(carried.exitCode, 0) << carried.output;
    EXPECT_THAT(carried.output, HasSubstr("copied to " + kCamera));
    EXPECT_THAT(copy.sh("./grade 08-perspective --submission assignments").output,
                HasSubstr("✓ perspective"));

    lab::writeFile(copy.root() / kCamera,
                   lab::readFile(copy.root() / kCamera) + "#error this one\n");
    const auto broken = copy.sh("./grade 08-perspective").output;
    EXPECT_THAT(broken, HasSubstr("the inherited file Camera.cpp does not compile (line"));
    EXPECT_THAT(broken, HasSubstr("Camera.cpp does not compile: line"));
    EXPECT_THAT(broken, Not(HasSubstr("`perspective` is not implemented yet")));
    const auto window = copy.buildAssignment("08-perspective");
    EXPECT_FALSE(window.succeeded());
    EXPECT_THAT(window.output, HasSubstr(kCamera + ":"));
}

}  // namespace
