#include "package/Leaks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace grader;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Twenty tokens and more, in a region and beside it.
const std::string kSecret = "float a = b * (c + d[1]) - e / f; g = h * i + j;";

CourseFiles filesWith(const std::string& path, const std::string& text) {
    CourseFiles course;
    course.files[path] = {text, false};
    return course;
}

const CourseFiles kSolution =
    filesWith("solutions/01-x/x.cpp", "void beside() { one(two, three); }\n// BEGIN TODO(tilt)\n" +
                                          kSecret + "\n// END TODO(tilt)\n");

std::vector<Leak> leaksIn(const std::string& text, const CourseFiles& known = {}) {
    return leaksOf(filesWith("docs/page.md", text), kSolution, known);
}

TEST(Leaks, ARunOfTwentyTokensIsFoundWhateverItsLayout) {
    const auto leaks = leaksIn("see:\nfloat a=b*(c+d[1])\n   - e/f;g=h*i+j ;");
    ASSERT_THAT(leaks, SizeIs(1));
    EXPECT_EQ(leaks[0].path, "docs/page.md");
    EXPECT_EQ(leaks[0].source, "solutions/01-x/x.cpp, region tilt");
    EXPECT_THAT(leaks[0].words, HasSubstr("float a = b * ( c"));
}

TEST(Leaks, CommentsAndStringsHideNothing) {
    EXPECT_THAT(leaksIn("// " + kSecret), SizeIs(1));
    EXPECT_THAT(leaksIn("/* float a = b * (c +\n * nothing */" + kSecret), SizeIs(1));
    EXPECT_THAT(leaksIn("{\"body\": \"" + kSecret + "\"}"), SizeIs(1));
    EXPECT_THAT(leaksIn("`float a = b * (c + d[1])\\n - e / f; g = h * i + j;`"), SizeIs(1));
    EXPECT_THAT(leaksIn("float a = b /* but */ * (c + d[1]) // or\n - e / f; g = h * i + j;"),
                SizeIs(1));
}

TEST(Leaks, FewerTokensOtherTokensAndWhatIsKnownAreNone) {
    EXPECT_THAT(leaksIn("float a = b * (c + d[1]) - e"), IsEmpty());
    EXPECT_THAT(leaksIn("float a = b * (c + d[2]) - e / f; g = h * i + k;"), IsEmpty());
    EXPECT_THAT(leaksIn("void beside() { one(two, three); }"), IsEmpty());
    EXPECT_THAT(leaksIn(kSecret, filesWith("common/x.h", kSecret)), IsEmpty());
    EXPECT_THAT(leaksIn(kSecret + std::string("\xff\0", 2)), IsEmpty()) << "no text";
}

}  // namespace
