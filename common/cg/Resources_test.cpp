#include <cg/Error.h>
#include <cg/GlTest.h>
#include <cg/Resources.h>
#include <cg/TemporaryFolder.h>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

class ResourcesTest : public ::testing::Test {
protected:
    void SetUp() override { fs::current_path(here.path()); }
    void TearDown() override { fs::current_path(before); }

    fs::path before = fs::current_path();
    cg::TemporaryFolder here, first, second;
};

TEST_F(ResourcesTest, LooksInTheCurrentFolderThenInTheAddedOnesInOrder) {
    cg::addResourceFolder(first.path());
    cg::addResourceFolder(second.path());
    const std::string inSecond = second.write("shaders/x.vert", "2");
    EXPECT_EQ(cg::findResource("shaders/x.vert"), inSecond);
    const std::string inFirst = first.write("shaders/x.vert", "1");
    EXPECT_EQ(cg::findResource("shaders/x.vert"), inFirst);
    here.write("shaders/x.vert", "0");
    EXPECT_EQ(cg::findResource("shaders/x.vert"), "shaders/x.vert");
    EXPECT_EQ(cg::findResource(inSecond), inSecond);
}

TEST_F(ResourcesTest, ListsEachPlaceOnceWhenNothingIsFound) {
    cg::addResourceFolder(first.path());
    cg::addResourceFolder(first.path());
    fs::create_directory(here.path("folder.vert"));
    const std::string text = cg::messageOf<cg::Error>([] { cg::findResource("folder.vert"); });
    EXPECT_NE(text.find("file folder.vert not found"), std::string::npos) << text;
    EXPECT_NE(text.find(here.path("folder.vert")), std::string::npos) << text;
    const std::size_t place = text.find(first.path("folder.vert"));
    ASSERT_NE(place, std::string::npos) << text;
    EXPECT_EQ(text.find(first.path("folder.vert"), place + 1), std::string::npos) << text;
}

}  // namespace
