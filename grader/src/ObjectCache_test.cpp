#include "ObjectCache.h"

#include <gtest/gtest.h>

#include "testing/Tree.h"

namespace {

using namespace grader;
using testing_help::Tree;

std::size_t entriesIn(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(ObjectCache, GivesBackWhatWasStoredWithItsLog) {
    const Tree tree;
    const ObjectCache cache(tree / "cache");
    const std::string object(
        "\x7f"
        "ELF\0\xff",
        6);
    cache.store("key", tree.write("a.o", object), "a warning\n");
    EXPECT_EQ(cache.fetch("key", tree / "b.o"), "a warning\n");
    EXPECT_EQ(readFile(tree / "b.o"), object);
    EXPECT_EQ(fs::status(tree / "b.o").permissions(), fs::perms(0644));
}

TEST(ObjectCache, KnowsNothingElse) {
    const Tree tree;
    const ObjectCache cache(tree / "cache");
    EXPECT_EQ(cache.fetch("key", tree / "b.o"), std::nullopt) << "not even its folder is there";
    cache.store("key", tree.write("a.o", "object"), "");
    EXPECT_EQ(cache.fetch("other", tree / "b.o"), std::nullopt);
    EXPECT_FALSE(fs::exists(tree / "b.o"));
}

TEST(ObjectCache, AHalfWrittenEntryIsNotTaken) {
    const Tree tree;
    const ObjectCache cache(tree / "cache");
    tree.write("cache/key/object", "half an obj");
    EXPECT_EQ(cache.fetch("key", tree / "b.o"), std::nullopt);
    tree.write("cache/other/log", "no object");
    EXPECT_EQ(cache.fetch("other", tree / "b.o"), std::nullopt);
    cache.store("key", tree.write("a.o", "object"), "log");
    EXPECT_EQ(cache.fetch("key", tree / "b.o"), "log") << "it can be mended";
}

TEST(ObjectCache, AnEntryThatWouldFillTheDiskIsNotKept) {
    const Tree tree;
    const ObjectCache cache(tree / "cache");
    const fs::path made = tree.write("a.o", "object");
    fs::resize_file(made, ObjectCache::kLargestEntry + 1);
    cache.store("key", made, "");
    EXPECT_EQ(cache.fetch("key", tree / "b.o"), std::nullopt);
    EXPECT_FALSE(fs::exists(tree / "cache/key"));
}

TEST(ObjectCache, ForgetsTheOldest) {
    const Tree tree;
    const ObjectCache cache(tree / "cache");
    const auto now = fs::file_time_type::clock::now();
    for (std::size_t i = 0; i < ObjectCache::kMostEntries; ++i) {
        const fs::path entry = tree / "cache" / std::to_string(i);
        fs::create_directories(entry);
        fs::last_write_time(entry, now - std::chrono::hours(1 + i));
    }
    cache.store("new", tree.write("a.o", "object"), "log");
    EXPECT_LE(entriesIn(tree / "cache"), ObjectCache::kMostEntries);
    EXPECT_GE(entriesIn(tree / "cache"), ObjectCache::kMostEntries / 2) << "not too many at once";
    EXPECT_TRUE(cache.fetch("new", tree / "b.o"));
    EXPECT_TRUE(fs::exists(tree / "cache/0"));
    EXPECT_FALSE(fs::exists(tree / "cache" / std::to_string(ObjectCache::kMostEntries - 1)));
}

}  // namespace
