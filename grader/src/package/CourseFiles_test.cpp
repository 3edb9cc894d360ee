#include "package/CourseFiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "Process.h"
#include "package/PlatformPackage.h"
#include "testing/Tree.h"

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

TEST_F(CourseFilesTest, WhatIsNewInTheCourseMustBeCommitted) {
    write("docs/new.md", "new");
    write("docs/kept.swp", "ignored");
    write(".git/info/exclude", "*.swp\n");
    EXPECT_THAT([&] { committedFiles(root()); },
                ThrowsMessage<Error>(HasSubstr("does not keep these files:\n  docs/new.md\n"
                                               "Commit")));
    fs::remove(root() / "docs/new.md");
    EXPECT_FALSE(committedFiles(root()).files.contains("docs/kept.swp"));
}

TEST_F(CourseFilesTest, OfARenamedFileTheNewNameIsSaid) {
    sh("git mv a.txt c.txt");
    EXPECT_THAT([&] { committedFiles(root()); },
                ThrowsMessage<Error>(HasSubstr("are not:\n  c.txt\nCommit them")));
}

TEST_F(CourseFilesTest, MoreThanIsReadIsSaid) {
    sh("blob=$(git hash-object -w a.txt) && awk -v blob=$blob 'BEGIN { for (i = 0; i < 80000; ++i)"
       " printf \"100644 %s 0\\t%0220d\\n\", blob, i }' | git update-index --index-info");
    EXPECT_THAT([&] { committedFiles(root()); },
                ThrowsMessage<Error>(HasSubstr("git status lists more than is read")));
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
    writeArchive(course, work_.path() / "new/x.zip");
    EXPECT_TRUE(fs::exists(work_.path() / "new/x.zip"));
    for (const char* name : {"x.tar.gz", "x.zip"})
        EXPECT_THAT([&] { writeTree(course, work_.path() / name); },
                    ThrowsMessage<Error>(HasSubstr("expected the name of a folder")))
            << name;
    EXPECT_THAT([&] { writeTree(course, out / "a.txt"); },
                ThrowsMessage<Error>(HasSubstr("a.txt is a file: name a folder")));
}

TEST(PlatformPackage, TwoAssignmentsMayNeedEachOther) {
    const testing_help::Tree tree;
    for (const auto& [id, other] : {std::pair("01-one", "02-two"), {"02-two", "01-one"}})
        tree.write(fmt::format("assignments/{}/assignment.json", id),
                   fmt::format(R"json({{
            "format": 1, "id": "{}", "title": "Tiny", "chapter": 1, "summary": "Small.",
            "submit": ["turn.cpp"], "inherits": {{"{}.cpp": "{}"}},
            "limits": {{}}, "frames": [], "starter_passes": [],
            "tasks": [{{"id": "turn", "title": "Turn", "points": 100, "needs": [], "hint": "Turn."}}]
            }})json",
                               id, other, other));
    CourseFiles course;
    for (const char* each :
         {"grader/platforms/prairielearn/README.md", "grader/platforms/prairielearn/run.sh",
          "solutions/01-one/turn.cpp", "solutions/02-two/turn.cpp", "solutions/03-three/turn.cpp"})
        course.files[each] = {"text"};
    const CourseFiles made =
        prairieLearnPackage({course, loadAssignment(tree.path(), "01-one"), 1});
    EXPECT_TRUE(made.files.contains("tests/solutions/01-one/turn.cpp"));
    EXPECT_TRUE(made.files.contains("tests/solutions/02-two/turn.cpp"));
    EXPECT_FALSE(made.files.contains("tests/solutions/03-three/turn.cpp"));
}

}  // namespace
