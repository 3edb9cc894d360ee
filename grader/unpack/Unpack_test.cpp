#include "unpack/Unpack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "Files.h"
#include "Process.h"
#include "testing/Tree.h"

namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing_help::Tree;
using unpack::whyNotCalled;

TEST(UnpackNames, HonestOnesAreTaken) {
    for (const char* name : {"rotation.cpp", "06-rotation/rotation.cpp", "./a/b", "a/", "Übung 6/x",
                             "__MACOSX/._rotation.cpp", "a..b/..c"})
        EXPECT_THAT(whyNotCalled(name), IsEmpty()) << name;
}

TEST(UnpackNames, EachDangerIsNamed) {
    const std::pair<std::string, const char*> dangers[] = {
        {"", "has no name"},
        {"/etc/passwd", "is an absolute path"},
        {"../x", "leads out"},
        {"a/../../x", "leads out"},
        {"a\\..\\x", "no file name should have"},
        {"a\nb", "no file name should have"},
        {"a\x1b[2Jb", "no file name should have"},
        {"a\u202Eb", "no file name should have"},
        {std::string(256, 'a'), "longer than 255 bytes"},
    };
    for (const auto& [name, why] : dangers)
        EXPECT_THAT(whyNotCalled(name), HasSubstr(why)) << name;
    std::string deep = "x";
    for (int i = 0; i < 32; ++i)
        deep = "a/" + deep;
    EXPECT_THAT(whyNotCalled(deep), HasSubstr("folders deep"));
    EXPECT_THAT(whyNotCalled(deep.substr(2)), IsEmpty());
}

TEST(Unpack, SaysWhatAFileIsWhenItIsNoArchive) {
    const Tree tree;
    tree.write("text", "my homework");
    std::filesystem::create_directories(tree / "target");
    EXPECT_THAT(unpack::unpack(tree / "text", tree / "target"), HasSubstr("no zip, tar"));
    EXPECT_THAT(unpack::unpack(tree / "missing", tree / "target"), HasSubstr("no zip, tar"));
    EXPECT_TRUE(std::filesystem::is_empty(tree / "target"));
}

TEST(Unpack, RefusesADamagedGzipThatUnpacksToSomething) {
    const Tree tree;
    tree.write("rotation.cpp", "int x = 1;");
    const std::string archive = (tree / "a.tar.gz").string();
    ASSERT_TRUE(
        grader::run({"tar", "-C", tree.path().string(), "-czf", archive, "rotation.cpp"}, 20)
            .succeeded());
    const auto unpacked = [&](const char* target) {
        std::filesystem::create_directories(tree / target);
        return unpack::unpack(archive, tree / target);
    };
    EXPECT_THAT(unpacked("whole"), IsEmpty());
    std::string bytes = grader::readFile(archive);
    constexpr std::size_t kTrailer = 8;  // a checksum and a length
    bytes[bytes.size() - kTrailer] ^= 1;
    tree.write("a.tar.gz", bytes);
    EXPECT_THAT(unpacked("damaged"), HasSubstr("is damaged or cut off"));
    tree.write("a.tar.gz", bytes.substr(0, bytes.size() - kTrailer));
    EXPECT_THAT(unpacked("cut"), HasSubstr("is damaged or cut off"));
    EXPECT_TRUE(std::filesystem::is_empty(tree / "damaged"));
}

TEST(Unpack, SaysWhyAFileCannotBeWritten) {
    const Tree tree;
    tree.write("in/file", std::string(100000, 'x'));
    std::filesystem::create_directories(tree / "target");
    ASSERT_TRUE(
        grader::run({"tar", "-cf", (tree / "tar").string(), "-C", (tree / "in").string(), "file"},
                    10)
            .succeeded());
    // The first write takes as much as there is room for.
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit little{1000, before.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &little);
    const std::string said = testing_help::whatOf<std::runtime_error>(
        [&] { unpack::unpack(tree / "tar", tree / "target"); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, SIG_DFL);
    EXPECT_EQ(said, "cannot unpack: File too large");
}

}  // namespace
