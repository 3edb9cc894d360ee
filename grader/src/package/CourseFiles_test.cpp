#include "package/CourseFiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "Process.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Key;
using testing::ThrowsMessage;

class CourseFilesTest : public testing::Test {
protected:
    CourseFilesTest() {
        write("b/a program", "#!/bin/sh\n");
        fs::permissions(root() / "b/a program", fs::perms::owner_all);
        write("a.txt", "öne\n");
        write("secret/x", "x");
        write(".gitattributes", "/secret/** instructors\n/.gitattributes instructors\n");
        sh("git init -q . && git add -A && git -c user.name=n -c user.email=e commit -q -m m");
    }
    fs::path root() const { return work_.path() / "course"; }
    void write(const std::string& path, const std::string& text) {
        fs::create_directories((root() / path).parent_path());
        writeFile(root() / path, text);
    }
    void sh(const std::string& line) {
        const ProcessResult ran = run({"sh", "-c", "cd '" + root().string() + "' && " + line}, 30);
        ASSERT_TRUE(ran.succeeded()) << ran.output;
    }
    WorkFolder work_;
};

TEST_F(CourseFilesTest, AreThoseThatGitKeepsWithoutTheAttribute) {
    write("untracked", "no");
    EXPECT_THAT(committedFiles(root()).files, ElementsAre(Key(".gitattributes"), Key("a.txt"),
                                                          Key("b/a program"), Key("secret/x")));
    CourseFiles course = committedFiles(root(), "instructors");
    EXPECT_THAT(course.files, ElementsAre(Key("a.txt"), Key("b/a program")));
    EXPECT_TRUE(course.files["b/a program"].executable);
    course.remove("b");
    EXPECT_THAT(course.files, ElementsAre(Key("a.txt")));
}

TEST_F(CourseFilesTest, MustBeCommitted) {
    write("a.txt", "two\n");
    EXPECT_THAT([&] { committedFiles(root()); }, ThrowsMessage<Error>(HasSubstr("a.txt")));
    sh("git checkout -q a.txt && ln -s a.txt link && git add link && git -c user.name=n -c "
       "user.email=e commit -q -m m");
    EXPECT_THAT([&] { committedFiles(root()); }, ThrowsMessage<Error>(HasSubstr("takes no link")));
    fs::remove_all(root() / ".git");
    EXPECT_THAT([&] { committedFiles(root()); },
                ThrowsMessage<Error>(HasSubstr("not a git repository")));
}

TEST_F(CourseFilesTest, TheSameCommitGivesTheSameBytes) {
    const CourseFiles course = committedFiles(root());
    for (const char* end : {".zip", ".tar"}) {
        const fs::path one = work_.path() / (std::string("one") + end),
                       two = work_.path() / (std::string("two") + end);
        writeArchive(course, one);
        fs::last_write_time(root() / "a.txt", fs::file_time_type::clock::now());
        writeArchive(committedFiles(root()), two);
        EXPECT_EQ(readFile(one), readFile(two)) << end;
        EXPECT_GT(fs::file_size(one), 100u);
    }
    sh("tar -xf ../one.tar -C .. && cmp ../a.txt a.txt && test -x '../b/a program'");
}

TEST_F(CourseFilesTest, AreWrittenToAnEmptyPlaceOnly) {
    const CourseFiles course = committedFiles(root());
    const fs::path out = work_.path() / "out";
    writeTree(course, out);
    EXPECT_EQ(readFile(out / "a.txt"), "öne\n");
    EXPECT_THAT([&] { writeTree(course, out); }, ThrowsMessage<Error>(HasSubstr("is not empty")));
    EXPECT_THAT([&] { writeArchive(course, work_.path() / "x.rar"); },
                ThrowsMessage<Error>(HasSubstr(".zip or .tar")));
    EXPECT_THROW(writeArchive(course, work_.path() / "none/x.zip"), Error);
    EXPECT_FALSE(fs::exists(work_.path() / "none"));
}

}  // namespace
