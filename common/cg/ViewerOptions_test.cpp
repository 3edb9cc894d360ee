#include <cg/Error.h>
#include <cg/ViewerOptions.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

cg::ViewerOptions parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "viewer");
    return cg::parseViewerOptions(static_cast<int>(arguments.size()), arguments.data());
}

TEST(ViewerOptions, HasTheNotesSizeUnlessTold) {
    EXPECT_EQ(parse({}).width, 800);
    EXPECT_EQ(parse({}).height, 600);
    EXPECT_EQ(parse({}).screenshot, "");
    EXPECT_FALSE(parse({}).help);
}

TEST(ViewerOptions, ReadsEveryOption) {
    const auto options = parse({"--size", "400x300", "--screenshot", "a.png", "--help"});
    EXPECT_EQ(options.width, 400);
    EXPECT_EQ(options.height, 300);
    EXPECT_EQ(options.screenshot, "a.png");
    EXPECT_TRUE(options.help);
}

TEST(ViewerOptions, RefusesWhatItDoesNotKnow) {
    for (const char* size : {"400", "400x", "x300", "0x300", "400x99999", "-4x3", "400x300x2"}) {
        EXPECT_THROW(parse({"--size", size}), cg::Error) << size;
    }
    EXPECT_THROW(parse({"--size"}), cg::Error);
    EXPECT_THROW(parse({"--screenshot"}), cg::Error);
    EXPECT_THROW(parse({"--fullscreen"}), cg::Error);
    EXPECT_THROW(parse({"picture.png"}), cg::Error);
}

TEST(ViewerOptions, UsageNamesEveryOption) {
    const std::string usage = cg::viewerUsage("07-camera");
    for (const char* option : {"07-camera", "--size", "--screenshot", "--help"}) {
        EXPECT_NE(usage.find(option), std::string::npos) << option;
    }
}

}  // namespace
