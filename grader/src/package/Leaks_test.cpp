#include "package/Leaks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace grader;
using testing::ElementsAre;
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
}

TEST(Leaks, NoEncodingHidesAnything) {
    EXPECT_THAT(leaksIn(kSecret + "\xff"), SizeIs(1));
    EXPECT_THAT(leaksIn("// f\xfcr " + kSecret), SizeIs(1)) << "Latin-1";
    std::string wide = "\xff\xfe";  // UTF-16
    for (const char c : kSecret)
        wide += {c, '\0'};
    EXPECT_THAT(leaksIn(wide), SizeIs(1));
    EXPECT_THAT(leaksIn(std::string("\x7f\0\1x", 4) + kSecret), SizeIs(1)) << "a binary";
}

TEST(Leaks, ArchivesAndOtherBinariesCannotBeSearched) {
    const std::string zip("PK\3\4\24\0", 6);
    for (const char* path : {"autograder.zip", "docs/week.tar", "docs/page.md", "program"})
        EXPECT_THAT(unsearchable(filesWith(path, zip)), ElementsAre(path));
    for (const char* path : {"docs/window.png", "reference_images/01-x/signatures.cbor"})
        EXPECT_THAT(unsearchable(filesWith(path, zip)), IsEmpty());
    EXPECT_THAT(unsearchable(filesWith("docs/page.md", "f\xfcr, für\r\n\t\f")), IsEmpty());
}

}  // namespace
