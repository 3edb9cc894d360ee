#include <cg/Error.h>
#include <cg/Screenshot.h>
#include <cg/TemporaryFolder.h>
#include <cg/image.h>

#include <gtest/gtest.h>

namespace {

const cg::Pixels onePixel{1, 1, {10, 20, 30, 255}};

TEST(Screenshot, CountsUpAndOverwritesNothing) {
    const cg::TemporaryFolder folder;
    folder.write("view-2.png", "mine");
    const std::string stem = folder.path("view");
    EXPECT_EQ(cg::saveScreenshot(stem, onePixel), stem + ".png");
    EXPECT_EQ(cg::saveScreenshot(stem, onePixel), stem + "-3.png");
    EXPECT_EQ(std::filesystem::file_size(stem + "-2.png"), 4u);
    EXPECT_EQ(cg::readImage(stem + "-3.png").rgba, onePixel.rgba);
}

TEST(Screenshot, LeavesNothingBehindWhenItFails) {
    const cg::TemporaryFolder folder;
    EXPECT_THROW(cg::saveScreenshot(folder.path("absent/view"), onePixel), cg::Error);
    EXPECT_THROW(cg::saveScreenshot(folder.path("view"), cg::Pixels{0, 0, {}}), cg::Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
