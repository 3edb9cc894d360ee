#include "report/TerminalPictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace grader;
using testing::HasSubstr;

/// 8 x 8, of four squares: red, green above blue, white.
Picture fourSquares() {
    Picture picture{8, 8, {}};
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const bool right = x >= 4, low = y >= 4;
            const std::uint8_t red = right == low ? 255 : 0;
            picture.rgba.insert(picture.rgba.end(),
                                {red, static_cast<std::uint8_t>(right ? 255 : 0),
                                 static_cast<std::uint8_t>(low ? 255 : 0), 255});
        }
    return picture;
}

Picture flat(int width, int height, std::uint8_t grey) {
    Picture picture{width, height, {}};
    picture.rgba.assign(static_cast<std::size_t>(4 * width * height), grey);
    return picture;
}

TEST(Preview, OfEightByEightPixelsIsKnownText) {
    const std::string squares =
        "\033[38;2;255;0;0m\033[48;2;0;0;255m▀"
        "\033[38;2;0;255;0m\033[48;2;255;255;255m▀\033[0m";
    const std::string grey = "\033[38;2;7;7;7m\033[48;2;7;7;7m▀▀\033[0m";
    EXPECT_EQ(previewOf(fourSquares(), flat(8, 8, 7), 2, 1),
              " yoursreference\n " + squares + "  " + grey + "\n");
}

TEST(Preview, NamesStandAboveTheirPictures) {
    EXPECT_THAT(previewOf(flat(8, 8, 1), flat(8, 8, 2), 8, 3),
                HasSubstr("   yours     reference\n"));
}

TEST(Preview, ASmallPixelIsTheMeanOfTheLargeOnes) {
    EXPECT_THAT(previewOf(fourSquares(), flat(8, 8, 7), 1, 0), HasSubstr("\033[38;2;127;127;0m"));
}

TEST(Preview, HasTheShapeOfTheReferenceAndNoColourLeaks) {
    const std::string wide = previewOf(flat(3, 9, 1), flat(400, 300, 2), 32, 0);
    EXPECT_EQ(std::count(wide.begin(), wide.end(), '\n'), 1 + 12);
    const std::string thin = previewOf(flat(100, 1, 1), flat(100, 1, 2), 10, 0);
    EXPECT_EQ(std::count(thin.begin(), thin.end(), '\n'), 1 + 1);
    EXPECT_TRUE(thin.ends_with("\033[0m\n"));
}

TEST(Preview, NeedsATerminalWithTrueColour) {
    EXPECT_EQ(whyNoPreviews(true, "truecolor"), "");
    EXPECT_EQ(whyNoPreviews(true, "24bit"), "");
    EXPECT_THAT(whyNoPreviews(true, "yes"), HasSubstr("24-bit colour"));
    EXPECT_THAT(whyNoPreviews(true, nullptr), HasSubstr("24-bit colour"));
    EXPECT_THAT(whyNoPreviews(false, "truecolor"), HasSubstr("does not go to a terminal"));
}

}  // namespace
