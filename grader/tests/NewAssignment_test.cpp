// ./grade new-assignment, and all that an author does next, in a checkout of its own.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CourseCopy.h"
#include "Fields.h"

namespace {

using namespace grader;
using testing::HasSubstr;

const std::string kId = "12-first-steps";

TEST(NewAssignment, IsBuiltDrawnProvedGradedAndShown) {
    const lab::CourseCopy copy;
    const auto expect = [&](int code, const std::string& line) {
        const ProcessResult result = copy.sh(line, ".", 300);
        EXPECT_EQ(result.exitCode, code) << line << "\n" << result.output;
        return result.output;
    };
    expect(0, "./grade new-assignment " + kId);
    EXPECT_THAT(expect(2, "./grade new-assignment " + kId), HasSubstr("is there already"));

    // Each kind of file has a comment for its author, and none has the template's names.
    const std::string folders = " assignments/" + kId + " solutions/" + kId;
    const std::string advised = expect(0, "grep -rl AUTHOR:" + folders);
    for (const char* file :
         {"README.md", "polygon.cpp", "polygon.h", "scene.h", "app.cpp", "harness.cpp", "flat.vert",
          "FirstSteps_test.cpp", "FirstSteps_hidden_test.cpp"})
        EXPECT_THAT(advised, HasSubstr(file));
    expect(1, "grep -rniE 'skeleton|chapter 0|\\b00\\b'" + folders);

    const ProcessResult built = copy.buildAssignment(kId + "_tests " + kId);
    ASSERT_EQ(built.exitCode, 0) << built.output;
    EXPECT_THAT(built.output, testing::Not(HasSubstr("warning:")));

    EXPECT_THAT(expect(0, "./grade update-references " + kId),
                HasSubstr("7 references, 7 written"));
    // What docs/new-assignment.md shows is what is drawn.
    expect(0, "'" COMPARE_PICTURES "' reference_images/" + kId +
                  "/pentagon.png docs/new-assignment.png");
    EXPECT_THAT(expect(0, "./grade check-course " + kId), HasSubstr(kId + ": consistent"));
    EXPECT_THAT(expect(0, "./grade check-recognition " + kId), HasSubstr(" 0 findings"));

    const Json starter = Json::parse(expect(1, "./grade --json - " + kId));
    EXPECT_EQ(starter.at("points"), 0);
    EXPECT_EQ(starter.at("tasks")[0].at("status"), "not_implemented");
    const Json solution =
        Json::parse(expect(0, "./grade --json - --submission solutions --seed 7 " + kId));
    EXPECT_EQ(solution.at("points"), 100);

    // The window opens, shows something, names what is not implemented, and quits.
    expect(0, "common/window_test/starter_test.sh \"$PWD\"/build/release/windows/" + kId + " " +
                  kId + " '" COMPARE_PICTURES "'");
}

}  // namespace
