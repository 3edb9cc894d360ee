// `grader compare`, as a person runs it on files.

#include <OpenImageIO/imageio.h>

#include <limits>

#include "Lab.h"

namespace {

using lab::Graded;
using lab::runGrader;
using testing::AssertionResult;

constexpr int kSide = 64;

class Compare : public testing::Test {
protected:
    /// A picture with a square of this colour at column `x` before grey; floats, as EXR has them.
    std::string picture(const std::string& name, float x, float red, float corner = 0.2f) {
        std::vector<float> rgb(3 * kSide * kSide, 0.2f);
        for (int row = 20; row < 40; ++row)
            for (int column = 0; column < 20; ++column) {
                const auto at = static_cast<std::size_t>(3 * (row * kSide + column + int(x)));
                rgb[at] = red;
                rgb[at + 1] = rgb[at + 2] = 0.1f;
            }
        rgb[0] = corner;
        return write(name, kSide, kSide, rgb);
    }
    std::string write(const std::string& name, int width, int height,
                      const std::vector<float>& rgb) {
        const std::string path = (folder_.path() / name).string();
        const auto out = OIIO::ImageOutput::create(path);
        EXPECT_TRUE(out && out->open(path, OIIO::ImageSpec(width, height, 3)) &&
                    out->write_image(OIIO::TypeDesc::FLOAT, rgb.data()) && out->close());
        return path;
    }
    std::string text(const std::string& name, const std::string& content) {
        const lab::fs::path path = folder_.path() / name;
        grader::writeFile(path, content);
        return path.string();
    }

private:
    grader::WorkFolder folder_;
};

AssertionResult says(const Graded& graded, int exitCode, const std::string& part) {
    if (graded.exitCode == exitCode && graded.text.find(part) != std::string::npos)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "expected exit code " << exitCode << " and \"" << part
                                       << "\", found " << graded.exitCode << " and:\n"
                                       << graded.text;
}

TEST_F(Compare, TheSamePictureEarnsEverything) {
    const std::string reference = picture("reference.png", 10, 0.9f);
    EXPECT_TRUE(says(runGrader({"compare", reference, reference}), 0, "score    1.000"));
}

TEST_F(Compare, WhatIsDisplacedIsSaidInPixels) {
    const std::string reference = picture("reference.png", 10, 0.9f);
    const Graded graded = runGrader({"compare", picture("mine.png", 22, 0.9f), reference});
    EXPECT_TRUE(says(graded, 1, "12 px too far right"));
}

TEST_F(Compare, JsonHoldsScoreAndFeatures) {
    const std::string reference = picture("reference.png", 10, 0.9f);
    const std::string blank =
        write("blank.png", kSide, kSide, std::vector<float>(3 * kSide * kSide, 0.2f));
    const Graded none =
        runGrader({"compare", blank, reference, "--feature", "square=" + blank, "--json"});
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_EQ(none.document.at("score"), 0);
    EXPECT_EQ(none.document.at("features").at(0).at("id"), "square");
    EXPECT_EQ(none.document.at("features").at(0).at("score"), 0);
    const Graded all =
        runGrader({"compare", reference, reference, "--feature", "square=" + blank, "--json"});
    EXPECT_EQ(all.exitCode, 0);
    EXPECT_EQ(all.document.at("features").at(0).at("score"), 1);
}

TEST_F(Compare, ABaselineEarnsNothing) {
    const std::string reference = picture("reference.png", 10, 0.9f);
    const std::string start = picture("start.png", 40, 0.9f);
    const Graded graded = runGrader({"compare", start, reference, "--baseline", start, "--json"});
    EXPECT_EQ(graded.document.at("score"), 0);
}

TEST_F(Compare, ReadsExrAndCountsWhatIsNoNumberAsWrong) {
    const std::string reference = picture("reference.exr", 10, 0.9f);
    const std::string broken = picture("mine.exr", 10, std::numeric_limits<float>::quiet_NaN());
    const Graded graded = runGrader({"compare", broken, reference});
    EXPECT_TRUE(says(graded, 1, "no number"));
    EXPECT_TRUE(says(runGrader({"compare", reference, reference}), 0, "score    1.000"));
}

TEST_F(Compare, AnotherSizeEarnsNothingAndIsSaid) {
    const std::string reference = picture("reference.png", 10, 0.9f);
    const std::string small = write("small.png", 32, 16, std::vector<float>(3 * 32 * 16, 0.5f));
    EXPECT_TRUE(says(runGrader({"compare", small, reference}), 1, "32"));
    EXPECT_TRUE(says(runGrader({"compare", reference, reference, "--baseline", small}), 2,
                     "expected 64 x 64 pixels as in the reference, found 32 x 16"));
}

TEST_F(Compare, BadInputIsNamed) {
    const std::string reference = picture("reference.png", 10, 0.9f);
    EXPECT_TRUE(says(runGrader({"compare", "/nonexistent.png", reference}), 2, "/nonexistent.png"));
    const std::string note = text("note.png", "no picture");
    EXPECT_TRUE(says(runGrader({"compare", note, reference}), 2, note));
    EXPECT_TRUE(says(runGrader({"compare", reference, reference, "--feature", "square"}), 2,
                     "expected NAME=PICTURE"));
    EXPECT_TRUE(says(runGrader({"compare", reference}), 2, "reference"));
}

}  // namespace
