#include "watch/FileWatch.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>

namespace {

using namespace grader;

class Watching : public testing::Test {
protected:
    fs::path file(const std::string& name) const { return work_.path() / name; }

    /// Written in place, as cp and some editors do; writeFile gives a new file the name.
    void overwrite(const std::string& name, const std::string& text) const {
        std::ofstream(file(name), std::ios::trunc) << text;
    }

    /// Whether a change is told within a second, or, when there is none to tell, at once.
    static bool hears(FileWatch& watch, int patienceMs = 1000) {
        using namespace std::chrono;
        const auto end = steady_clock::now() + milliseconds(patienceMs);
        for (;;) {
            // Folders above are watched, too, and others may write there all the time.
            const auto left = duration_cast<milliseconds>(end - steady_clock::now()).count();
            pollfd waiting{watch.descriptor(), POLLIN, 0};
            if (poll(&waiting, 1, std::max(0, int(left))) <= 0)
                return false;
            if (watch.takeEvents())
                return true;
            if (left <= 0)
                return false;
        }
    }

    /// Takes what the last step may still have to say.
    static void settle(FileWatch& watch) { watch.takeEvents(); }

    WorkFolder work_;
};

TEST_F(Watching, EveryWayToSaveIsHeard) {
    overwrite("a.cpp", "one");
    FileWatch watch({file("a.cpp")});
    EXPECT_FALSE(hears(watch, 0));

    overwrite("a.cpp", "two");
    EXPECT_TRUE(hears(watch)) << "in place";
    settle(watch);

    overwrite("a.cpp~new", "three");
    EXPECT_FALSE(hears(watch, 50)) << "another file";
    fs::rename(file("a.cpp~new"), file("a.cpp"));
    EXPECT_TRUE(hears(watch)) << "a new file by rename";
    settle(watch);

    overwrite("a.cpp", "four");
    EXPECT_TRUE(hears(watch)) << "in place, after a rename";
    settle(watch);

    fs::rename(file("a.cpp"), file("a.cpp.bak"));
    EXPECT_TRUE(hears(watch)) << "moved away";
    settle(watch);
    fs::copy_file(file("a.cpp.bak"), file("a.cpp"));
    EXPECT_TRUE(hears(watch)) << "come back";
    settle(watch);
    fs::remove(file("a.cpp"));
    EXPECT_TRUE(hears(watch)) << "removed";
}

TEST_F(Watching, AFileThatIsWrittenBitByBitIsHeardBeforeItIsClosed) {
    FileWatch watch({file("a.cpp")});
    std::ofstream out(file("a.cpp"));
    EXPECT_TRUE(hears(watch));
    settle(watch);
    out << "half" << std::flush;
    EXPECT_TRUE(hears(watch));
}

TEST_F(Watching, AFolderMayAppearVanishAndComeBack) {
    const fs::path shaders = work_.path() / "deep/er/shaders";
    FileWatch watch({shaders / "a.frag"});
    fs::create_directories(shaders);
    EXPECT_TRUE(hears(watch));
    while (hears(watch, 50)) {
    }
    overwrite("deep/er/shaders/a.frag", "one");
    EXPECT_TRUE(hears(watch));
    settle(watch);

    fs::remove_all(shaders);
    EXPECT_TRUE(hears(watch));
    while (hears(watch, 50)) {
    }
    fs::create_directories(shaders);
    EXPECT_TRUE(hears(watch));
    while (hears(watch, 50)) {
    }
    overwrite("deep/er/shaders/a.frag", "two");
    EXPECT_TRUE(hears(watch));
    settle(watch);

    fs::rename(work_.path() / "deep", work_.path() / "elsewhere");
    EXPECT_TRUE(hears(watch)) << "a folder above was renamed";
}

TEST_F(Watching, ContentsTellAChangeFromATouch) {
    overwrite("a.cpp", "one");
    const std::vector<fs::path> files = {file("a.cpp"), file("none.h")};
    const Contents before = contentsOf(files);
    EXPECT_EQ(before.at(file("none.h")), "");
    overwrite("a.cpp", "one");
    EXPECT_EQ(contentsOf(files), before);
    overwrite("a.cpp", "two");
    EXPECT_NE(contentsOf(files), before);
}

TEST_F(Watching, AFileThatIsEmptyForAMomentLooksUnfinished) {
    overwrite("a.cpp", "one");
    const std::vector<fs::path> files = {file("a.cpp"), file("b.cpp")};
    const Contents before = contentsOf(files);
    overwrite("a.cpp", "");
    const Contents empty = contentsOf(files);
    EXPECT_TRUE(looksUnfinished(before, empty));
    EXPECT_FALSE(looksUnfinished(empty, empty)) << "it was empty already";
    fs::remove(file("a.cpp"));
    EXPECT_TRUE(looksUnfinished(before, contentsOf(files)));
    overwrite("a.cpp", "two");
    overwrite("b.cpp", "");
    EXPECT_FALSE(looksUnfinished(before, contentsOf(files))) << "what is new may be empty";
}

}  // namespace
