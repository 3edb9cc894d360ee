#include "Files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "Error.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_help::Tree;
using testing_help::whatOf;

constexpr auto npos = std::string::npos;

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// Test vectors of FIPS 180-2.
TEST(Files, Sha256OfKnownTexts) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_NE(sha256(std::string("a\0b", 3)), sha256("a"));
}

TEST(Files, WhatIsWrittenIsRead) {
    const Tree tree;
    const std::string bytes("line\r\n\0\xff", 8);
    EXPECT_EQ(readFile(tree.write("file", bytes)), bytes);
    EXPECT_EQ(readFile(tree.write("empty", "")), "");
}

TEST(Files, WritingMakesFoldersAndReplacesWhole) {
    const Tree tree;
    tree.write("a/b/c.txt", "a long first text");
    tree.write("a/b/c.txt", "short");
    EXPECT_EQ(readFile(tree / "a/b/c.txt"), "short");
    EXPECT_EQ(filesIn(tree / "a/b"), 1u) << "nothing temporary stays";
}

TEST(Files, ThreadsThatWriteTheSameFileWriteItWhole) {
    const Tree tree;
    std::atomic<int> torn{0};
    std::vector<std::thread> threads;
    for (char each = 'a'; each < 'i'; ++each)
        threads.emplace_back([&, text = std::string(200000, each)] {
            for (int i = 0; i < 30; ++i) {
                writeFile(tree / "file", text);
                const std::string read = readFile(tree / "file");
                torn += read.size() != text.size() || read.find_first_not_of(read[0]) != npos;
            }
        });
    for (std::thread& each : threads)
        each.join();
    EXPECT_EQ(torn, 0);
}

TEST(Files, WhatCannotBeReadToItsEndIsNotTakenForWhole) {
    EXPECT_THAT(whatOf<Error>([] { readFile("/proc/self/mem"); }), HasSubstr("Input/output error"));
    EXPECT_THAT(whatOf<Error>([] { readFile("/tmp"); }), HasSubstr("it is a folder"));
}

TEST(Files, WhatCannotBeLookedAtThrowsNothing) {
    const Tree tree;
    fs::create_symlink("circle", tree / "circle");
    EXPECT_EQ(typeOf(tree / "circle"), fs::file_type::symlink);
    EXPECT_EQ(typeOf(tree / "circle/file"), fs::file_type::none);
    EXPECT_EQ(typeOf(tree / "nothing"), fs::file_type::not_found);
    EXPECT_THAT(entriesOf(tree / "circle"), IsEmpty());
    EXPECT_THAT(entriesOf(tree / "nothing"), IsEmpty());
    tree.write("b", "");
    tree.write("a", "");
    EXPECT_THAT(entriesOf(tree.path()), ElementsAre(tree / "a", tree / "b", tree / "circle"));
}

TEST(Files, AReaderKeepsTheTextThatItOpened) {
    const Tree tree;
    std::ifstream reader(tree.write("file", "the old text"));
    tree.write("file", "new");
    std::string text;
    std::getline(reader, text);
    EXPECT_EQ(text, "the old text");
}

TEST(Files, AFailedWriteLeavesNothingBehind) {
    const Tree tree;
    fs::create_directories(tree / "taken");
    EXPECT_ANY_THROW(tree.write("taken", "text"));
    EXPECT_TRUE(fs::is_directory(tree / "taken"));
}

TEST(Files, WhatCannotBeReadIsNamedWithTheReason) {
    const Tree tree;
    EXPECT_THAT(whatOf<Error>([&] { readFile(tree / "none"); }),
                testing::AllOf(HasSubstr((tree / "none").string()), HasSubstr("No such file")));
    EXPECT_THAT(whatOf<Error>([&] { readFile(tree.path()); }), HasSubstr("it is a folder"));
}

TEST(Files, AWorkFolderIsRemovedWithAllInIt) {
    fs::path path;
    {
        const WorkFolder work, other;
        path = work.path();
        EXPECT_NE(path, other.path());
        writeFile(path / "a/b", "text");
        fs::create_symlink("/nonexistent", path / "link");
    }
    EXPECT_FALSE(fs::exists(path));
}

TEST(Files, WorkOfProcessesThatWereKilledIsRemoved) {
    const Tree temporary;
    setenv("TMPDIR", temporary.path().c_str(), 1);
    std::string abandoned = (fs::temp_directory_path() / "course-XXXXXX").string();
    ASSERT_TRUE(mkdtemp(abandoned.data()));
    const WorkFolder inUse;
    writeFile(fs::path(abandoned) / "a/b", "text");
    removeAbandonedWork(1);
    EXPECT_TRUE(fs::exists(abandoned)) << "it may belong to a process that is just beginning";
    removeAbandonedWork(-1);
    EXPECT_FALSE(fs::exists(abandoned));
    EXPECT_TRUE(fs::exists(inUse.path()));
    unsetenv("TMPDIR");
}

TEST(Files, OthersPassThroughAWorkFolderButCannotListIt) {
    const WorkFolder work;
    struct stat status {};
    ASSERT_EQ(stat(work.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0711u);
}

TEST(Utf8, TextsOfAllLengthsOfSequences) {
    EXPECT_EQ(firstInvalidUtf8(""), npos);
    EXPECT_EQ(firstInvalidUtf8("int x;\t\r\n"), npos);
    EXPECT_EQ(firstInvalidUtf8("\u00e9 \u20ac \U0001F600 \U0010FFFF"), npos);
    EXPECT_EQ(firstInvalidUtf8("\xEF\xBB\xBF//"), npos) << "a byte-order mark";
}

TEST(Utf8, WhatNoEncoderWrites) {
    EXPECT_EQ(firstInvalidUtf8("ab\x80"), 2u) << "a continuation alone";
    EXPECT_EQ(firstInvalidUtf8("a\xC0\xAF"), 1u) << "overlong, 2 bytes";
    EXPECT_EQ(firstInvalidUtf8("a\xC1\xBF"), 1u) << "overlong, 2 bytes";
    EXPECT_EQ(firstInvalidUtf8("\xE0\x9F\xBF"), 0u) << "overlong, 3 bytes";
    EXPECT_EQ(firstInvalidUtf8("\xF0\x8F\xBF\xBF"), 0u) << "overlong, 4 bytes";
    EXPECT_EQ(firstInvalidUtf8("\xED\xA0\x80"), 0u) << "a surrogate";
    EXPECT_EQ(firstInvalidUtf8("\xED\x9F\xBF"), npos) << "the last before the surrogates";
    EXPECT_EQ(firstInvalidUtf8("\xF4\x90\x80\x80"), 0u) << "above U+10FFFF";
    EXPECT_EQ(firstInvalidUtf8("\xF5\x80\x80\x80"), 0u);
    EXPECT_EQ(firstInvalidUtf8("x\xFF"), 1u);
    EXPECT_EQ(firstInvalidUtf8("Gr\xFC\xDF"
                               "e"),
              2u)
        << "Latin-1";
}

TEST(Utf8, SequencesThatAreCut) {
    EXPECT_EQ(firstInvalidUtf8("ok\xC3"), 2u);
    EXPECT_EQ(firstInvalidUtf8("\xE2\x82"), 0u);
    EXPECT_EQ(firstInvalidUtf8("\xF0\x9F\x98"), 0u);
    EXPECT_EQ(firstInvalidUtf8("\xE2\x82z"), 0u);
}

TEST(Utf8, AZeroByteIsNoText) {
    EXPECT_EQ(firstInvalidUtf8(std::string("i\0n\0t\0", 6)), 1u) << "UTF-16 without a mark";
}

TEST(Utf8, TheSearchGoesOnFromAnyPlace) {
    EXPECT_EQ(firstInvalidUtf8("\xFF ok \xFE", 1), 5u);
    EXPECT_EQ(firstInvalidUtf8("\xFF ok", 1), npos);
}

}  // namespace
