#include <cg/Error.h>
#include <cg/TemporaryFolder.h>
#include <cg/image.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <thread>

#ifndef __SANITIZE_ADDRESS__  // which has a malloc of its own
namespace {

std::size_t scarceSize = 0;  // of blocks of this size there are only a few left
int blocksLeft = 0;

}  // namespace

extern "C" void* __libc_malloc(std::size_t size);

extern "C" void* malloc(std::size_t size) noexcept {
    return size == scarceSize && blocksLeft-- == 0 ? nullptr : __libc_malloc(size);
}
#endif

namespace {

using cg::Pixels;

Pixels pattern(int width, int height) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int value : {x * 7, y * 11, x * y, 255}) {
                rgba.push_back(static_cast<std::uint8_t>(value));
            }
        }
    }
    return {width, height, rgba, {}};
}

std::string bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A DDS file of 4 x 4 x 4 pixels.
std::string volume() {
    std::array<std::uint32_t, 32 + 4 * 4 * 4> words = {0x20534444, 124, 0x801007, 4, 4, 16, 4};
    words[19] = 32;  // the pixels: 32 bits each, of which every channel has eight
    words[20] = 0x41;
    words[22] = 32;
    words[23] = 0xff;
    words[24] = 0xff00;
    words[25] = 0xff0000;
    words[26] = 0xff000000;
    words[27] = 0x1008;
    words[28] = 0x200000;  // a volume
    return {reinterpret_cast<const char*>(words.data()), sizeof words};
}

class ImageTest : public ::testing::Test {
protected:
    /// Text of the error that reading the file gives.
    std::string readError(const std::string& path) {
        try {
            cg::readImage(path);
        } catch (const cg::Error& failure) {
            return failure.what();
        }
        ADD_FAILURE() << path << " was read";
        return "";
    }

    cg::TemporaryFolder folder;
};

TEST_F(ImageTest, WritesAndReadsAnOddWidth) {
    const Pixels pixels = pattern(333, 5);
    cg::writeImage(folder.path("a.png"), pixels);
    const Pixels back = cg::readImage(folder.path("a.png"));
    EXPECT_EQ(back.width, 333);
    EXPECT_EQ(back.height, 5);
    EXPECT_EQ(back.rgba, pixels.rgba);
}

TEST_F(ImageTest, DropsAlphaWithoutTouchingTheColours) {
    Pixels pixels = pattern(9, 4);
    for (std::size_t k = 3; k < pixels.rgba.size(); k += 4) {
        pixels.rgba[k] = 10;
    }
    cg::writeImage(folder.path("a.png"), pixels);
    EXPECT_EQ(cg::readImage(folder.path("a.png")).rgba, pattern(9, 4).rgba);
}

TEST_F(ImageTest, TheSamePixelsGiveTheSameBytesAtAnyTime) {
    cg::writeImage(folder.path("a.png"), pattern(20, 20));
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    cg::writeImage(folder.path("b.png"), pattern(20, 20));
    EXPECT_FALSE(bytes(folder.path("a.png")).empty());
    EXPECT_EQ(bytes(folder.path("a.png")), bytes(folder.path("b.png")));
}

TEST_F(ImageTest, SpreadsGreyOverTheColours) {
    folder.write("grey.pgm", std::string("P5 2 1 255\n") + char(200) + char(3));
    EXPECT_EQ(cg::readImage(folder.path("grey.pgm")).rgba,
              (std::vector<std::uint8_t>{200, 200, 200, 255, 3, 3, 3, 255}));
}

TEST_F(ImageTest, AMissingFileIsNamed) {
    const std::string path = folder.path("absent.png");
    EXPECT_EQ(readError(path), path + ": no such file");
}

TEST_F(ImageTest, SomethingElseThanAPictureIsNamed) {
    const std::string path = folder.write("text.png", "this is no picture\n");
    EXPECT_EQ(readError(path).find(path + ": not a picture"), 0u) << readError(path);
}

TEST_F(ImageTest, ADamagedPictureIsNamed) {
    cg::writeImage(folder.path("a.png"), pattern(100, 100));
    const std::string whole = bytes(folder.path("a.png"));
    const std::string path = folder.write("half.png", whole.substr(0, whole.size() / 2));
    EXPECT_EQ(readError(path).find(path), 0u) << readError(path);
}

TEST_F(ImageTest, AVolumeIsRefusedWhateverItsName) {
    for (const char* name : {"volume.dds", "volume.png"}) {
        const std::string path = folder.write(name, volume());
        EXPECT_EQ(readError(path),
                  path + ": the picture is a volume of 4 layers; save it flat, as .png");
    }
}

TEST_F(ImageTest, ANameThatNoFileCanHaveIsNamed) {
    const std::string path = folder.path(std::string(300, 'a') + ".png");
    EXPECT_EQ(readError(path), path + ": File name too long");
}

TEST_F(ImageTest, RefusesWhatItCannotWrite) {
    EXPECT_THROW(cg::writeImage(folder.path("a.nothing"), pattern(2, 2)), cg::Error);
    EXPECT_THROW(cg::writeImage(folder.path("absent/a.png"), pattern(2, 2)), cg::Error);
    EXPECT_THROW(cg::writeImage(folder.path("a.png"), Pixels{2, 2, {1, 2, 3}}), cg::Error);
    EXPECT_THROW(cg::writeImage(folder.path("a.png"), Pixels{0, 2, {}}), cg::Error);
    EXPECT_THROW(cg::writeImage(folder.path("a.png"), Pixels{100000, 1, {}}), cg::Error);
}

TEST_F(ImageTest, TheCFunctionsDoTheSame) {
    const Pixels pixels = pattern(7, 3);
    const std::string path = folder.path("c.png");
    char error[200] = "";
    ASSERT_EQ(cg_image_write(path.c_str(), 7, 3, pixels.rgba.data(), error, sizeof error), 0);
    int width = 0, height = 0;
    unsigned char *rgba = nullptr, *broken = nullptr;
    ASSERT_EQ(cg_image_read(path.c_str(), &width, &height, &rgba, &broken, error, sizeof error), 0);
    EXPECT_EQ(width, 7);
    EXPECT_EQ(height, 3);
    EXPECT_EQ(std::vector<std::uint8_t>(rgba, rgba + 7 * 3 * 4), pixels.rgba);
    std::free(rgba);
    EXPECT_STREQ(error, "");

    EXPECT_EQ(cg_image_read("absent.png", &width, &height, &rgba, &broken, error, sizeof error), 1);
    EXPECT_EQ(rgba, nullptr);
    EXPECT_STREQ(error, "absent.png: no such file");
    EXPECT_EQ(cg_image_write("a.png", 0, 3, pixels.rgba.data(), error, 6), 1);
    EXPECT_STREQ(error, "a.png");
}

#ifndef __SANITIZE_ADDRESS__
TEST_F(ImageTest, TheCFunctionsHandOverAllOrNothing) {
    std::vector<float> values(31 * 29);
    values[7] = NAN;  // so that there are two blocks to hand over
    const std::string path = folder.write(
        "a.pfm", "Pf\n31 29\n-1.0\n" + std::string(reinterpret_cast<char*>(values.data()),
                                                   values.size() * sizeof(float)));
    int width = 0, height = 0, failures = 0;
    unsigned char *rgba = nullptr, *broken = nullptr;
    const auto read = [&](int blocks) {
        blocksLeft = blocks;
        scarceSize = values.size();
        const int failed = cg_image_read(path.c_str(), &width, &height, &rgba, &broken, nullptr, 0);
        scarceSize = 0;
        return failed != 0;
    };
    for (; read(failures); ++failures) {
        EXPECT_EQ(rgba, nullptr);
        EXPECT_EQ(broken, nullptr);
    }
    EXPECT_GT(failures, 0);
    ASSERT_NE(broken, nullptr);
    EXPECT_EQ(std::count(broken, broken + values.size(), 1), 1);
    std::free(rgba);
    std::free(broken);
}
#endif

}  // namespace
