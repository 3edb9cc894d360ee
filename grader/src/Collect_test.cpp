#include "Collect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "Error.h"
#include "testing/AsNobody.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_help::AsNobody;
using testing_help::Tree;
using testing_help::whatOf;

/// A small course, and a submission that a test fills.
class Collecting : public testing::Test {
protected:
    Collecting() {
        const std::string camera = "assignments/07-camera/";
        for (const char* name : {"Camera.h", "Camera.cpp"})
            course.write(camera + name, std::string("starter ") + name);
        for (const char* name : {"harness.cpp", "scene.h", "scene.cpp", "app.cpp", "README.md",
                                 "assignment.json", "tests/LookAt_test.cpp", "shaders/p.vert"})
            course.write(camera + name, std::string("our ") + name);
        course.write("assignments/06-rotation/rotation.cpp", "starter rotation");
        manifest.id = "07-camera";
        manifest.folder = course / "assignments/07-camera";
        manifest.submit = {"Camera.h", "Camera.cpp"};
        manifest.inherits = {{"rotation.cpp", "06-rotation"}};
    }
    void submit(const std::string& name, const std::string& content) {
        hand.write("07-camera/" + name, content);
    }
    void submitBoth() {
        submit("Camera.h", "mine h");
        submit("Camera.cpp", "mine cpp");
    }
    Collected collected() { return collect(course.path(), manifest, {hand.path(), true}); }
    Collected atHome() { return collect(course.path(), manifest, {course / "assignments", true}); }
    /// Content and origin of one staged file.
    static std::string staged(const Collected& all, const std::string& name) {
        const StagedFile* file = all.stage.find(name);
        return file ? file->content + " (" + file->origin + ")" : "nothing";
    }
    /// The complaint about Camera.cpp.
    std::string complaint() {
        const Collected all = collected();
        if (all.unreadable.size() != 1)
            return std::to_string(all.unreadable.size()) + " complaints";
        EXPECT_EQ(all.unreadable[0].severity, "error");
        return placeOf(all.unreadable[0]) + all.unreadable[0].message;
    }

    Tree course, hand;
    Manifest manifest;
};

TEST_F(Collecting, FilesOfAFolderPerAssignment) {
    submitBoth();
    const Collected all = collected();
    EXPECT_EQ(staged(all, "Camera.h"), "mine h (submission)");
    EXPECT_EQ(staged(all, "Camera.cpp"), "mine cpp (submission)");
    EXPECT_EQ(all.stage.find("Camera.h")->role, Role::own);
    EXPECT_THAT(all.notices, IsEmpty());
    EXPECT_THAT(all.ignored, IsEmpty());
    EXPECT_THAT(all.unreadable, IsEmpty());
}

TEST_F(Collecting, FilesOfOneFolder) {
    hand.write("Camera.h", "mine h");
    hand.write("Camera.cpp", "mine cpp");
    hand.write("06-rotation/rotation.cpp", "not looked for here");
    const Collected all = collect(course.path(), manifest, {hand.path(), false});
    EXPECT_EQ(staged(all, "Camera.cpp"), "mine cpp (submission)");
    EXPECT_EQ(staged(all, "rotation.cpp"), "starter rotation (starter)");
    EXPECT_THAT(all.ignored, ElementsAre("06-rotation/"));
}

TEST(SubmissionIn, AFolderHoldsOneAssignmentOrAFolderForEachOrIsACopyOfTheCourse) {
    const std::vector<std::string> known = {"06-rotation", "07-camera"};
    const Tree one, each, copy, link;
    one.write("rotation.cpp", "");
    EXPECT_FALSE(submissionIn(one.path(), known).perAssignment);
    each.write("07-camera/Camera.cpp", "");
    EXPECT_TRUE(submissionIn(each.path(), known).perAssignment);
    EXPECT_EQ(submissionIn(each.path(), known).folder, each.path());
    copy.write("assignments/07-camera/Camera.cpp", "");
    EXPECT_TRUE(submissionIn(copy.path(), known).perAssignment);
    EXPECT_EQ(submissionIn(copy.path(), known).folder, copy / "assignments");
    fs::create_directory_symlink(copy / "assignments", link / "assignments");
    EXPECT_FALSE(submissionIn(link.path(), known).perAssignment) << "links are not followed";
    fs::create_directory_symlink(each.path(), link / "named");
    EXPECT_TRUE(submissionIn(link / "named", known).perAssignment)
        << "but for the one that was named";
}

TEST_F(Collecting, AMissingFileIsNamedAndReplaced) {
    submit("Camera.h", "mine h");
    const Collected all = collected();
    EXPECT_EQ(staged(all, "Camera.cpp"), "starter Camera.cpp (starter)");
    EXPECT_EQ(staged(all, "Camera.h"), "mine h (submission)");
    EXPECT_THAT(all.notices, ElementsAre("Camera.cpp is missing: graded with the starter's file"));
    EXPECT_THAT(all.unreadable, IsEmpty());
}

TEST_F(Collecting, NothingAtAllIsTheStarter) {
    const Collected all = collected();
    EXPECT_EQ(all.notices.size(), 2u);
    EXPECT_EQ(staged(all, "Camera.h"), "starter Camera.h (starter)");
}

TEST_F(Collecting, AnInheritedFileIsLookedUpFromNearToFar) {
    submitBoth();
    EXPECT_EQ(staged(collected(), "rotation.cpp"), "starter rotation (starter)");
    course.write("solutions/06-rotation/rotation.cpp", "solved rotation");
    EXPECT_EQ(staged(collected(), "rotation.cpp"), "solved rotation (solutions)");
    hand.write("06-rotation/rotation.cpp", "my old rotation");
    EXPECT_EQ(staged(collected(), "rotation.cpp"), "my old rotation (submission)");
    submit("rotation.cpp", "my new rotation");
    const Collected all = collected();
    EXPECT_EQ(staged(all, "rotation.cpp"), "my new rotation (submission)");
    EXPECT_EQ(all.stage.find("rotation.cpp")->role, Role::inherited);
    EXPECT_THAT(all.ignored, IsEmpty()) << "it was taken";
}

TEST_F(Collecting, ATaskInAnInheritedFileIsNeverTheSolutions) {
    const auto with = [](const std::string& body, const std::string& other) {
        return "// BEGIN TODO(tilt)\n" + body + "\n// END TODO(tilt)\n// BEGIN TODO(turn)\n" +
               other + "\n// END TODO(turn)\n";
    };
    course.write("assignments/06-rotation/rotation.cpp", with("tilt?", "turn?"));
    course.write("assignments/06-rotation/rotation.h", "starter h");
    course.write("solutions/06-rotation/rotation.cpp", with("tilted", "turned"));
    manifest.inherits = {{"rotation.cpp", "06-rotation"}, {"rotation.h", "06-rotation"}};
    const auto names = [&] {
        std::vector<std::string> all;
        for (const auto& [name, starter] : handedIn(manifest))
            all.push_back(name);
        return all;
    };
    EXPECT_THAT(names(), ElementsAre("Camera.cpp", "Camera.h"));
    EXPECT_EQ(substituteFor(course.path(), manifest, "rotation.cpp").content,
              with("tilted", "turned"));

    manifest.tasks.push_back({.id = "tilt"});
    EXPECT_THAT(names(), ElementsAre("Camera.cpp", "Camera.h", "rotation.cpp", "rotation.h"));
    submitBoth();
    const Collected all = collected();
    EXPECT_EQ(staged(all, "rotation.cpp"), with("tilt?", "turned") + " (solutions)");
    EXPECT_THAT(all.notices, ElementsAre(HasSubstr("rotation.cpp of 06-rotation is missing, and "
                                                   "tilt with it")));
    hand.write("06-rotation/rotation.cpp", with("mine", "mine"));
    EXPECT_EQ(staged(collected(), "rotation.cpp"), with("mine", "mine") + " (submission)");
}

TEST_F(Collecting, AnInheritedFileThatIsNowhereIsTheManifestsFault) {
    manifest.inherits = {{"cross.cpp", "06-rotation"}};
    EXPECT_THAT(whatOf<Error>([&] { collected(); }),
                HasSubstr("inherited file cross.cpp is nowhere in assignments/06-rotation"));
}

TEST_F(Collecting, OurFilesAreStagedButNoTestsAndNoWindow) {
    const Collected all = collected();
    for (const char* name : {"harness.cpp", "scene.h", "scene.cpp", "shaders/p.vert"}) {
        EXPECT_EQ(staged(all, name), std::string("our ") + name + " (assignment)");
        EXPECT_EQ(all.stage.find(name)->role, Role::provided);
    }
    for (const char* name : {"app.cpp", "README.md", "assignment.json", "tests/LookAt_test.cpp"})
        EXPECT_EQ(staged(all, name), "nothing") << name;
}

TEST_F(Collecting, FilesOutsideTheManifestAreNamedAndNeverStaged) {
    submitBoth();
    submit("harness.cpp", "my harness: everything passes");
    submit("tests/LookAt_test.cpp", "my tests");
    submit("assignment.json", "my points");
    submit("extra.cpp", "int main() {}");
    submit(".git/config", "");
    const Collected all = collected();
    EXPECT_EQ(staged(all, "harness.cpp"), "our harness.cpp (assignment)");
    EXPECT_EQ(staged(all, "extra.cpp"), "nothing");
    EXPECT_EQ(staged(all, "tests/LookAt_test.cpp"), "nothing");
    EXPECT_THAT(all.ignored,
                ElementsAre(".git/", "assignment.json", "extra.cpp", "harness.cpp", "tests/"));
    for (const StagedFile& file : all.stage.files)
        EXPECT_EQ(file.content.find("my "), std::string::npos) << file.name;
}

TEST_F(Collecting, UnchangedCopiesOfOurFilesAreNotWorthAWord) {
    submitBoth();
    for (const char* name : {"harness.cpp", "app.cpp", "README.md"})
        submit(name, std::string("our ") + name);
    EXPECT_THAT(collected().ignored, IsEmpty());
}

TEST_F(Collecting, TheAssignmentsFolderItselfIsASubmission) {
    const Collected all = atHome();
    EXPECT_THAT(all.ignored, IsEmpty());
    EXPECT_THAT(all.notices, IsEmpty());
    EXPECT_EQ(staged(all, "Camera.h"), "starter Camera.h (submission)");
}

TEST_F(Collecting, WhatIsMissingThereIsTheStarterItself) {
    const auto complaints = [](const Collected& all) {
        EXPECT_THAT(all.notices, IsEmpty());
        std::vector<std::string> messages;
        for (const Diagnostic& each : all.unreadable)
            messages.push_back(placeOf(each) + each.message);
        return messages;
    };
    const std::string camera =
        "Camera.cpp is missing: git restore assignments/07-camera/Camera.cpp brings the starter's "
        "back";
    fs::remove(course / "assignments/07-camera/Camera.cpp");
    EXPECT_THAT(complaints(atHome()), ElementsAre(camera));
    fs::remove(course / "assignments/06-rotation/rotation.cpp");
    EXPECT_THAT(complaints(atHome()),
                ElementsAre(camera, HasSubstr("restore assignments/06-rotation/rotation.cpp")));
    course.write("assignments/07-camera/camera.cpp", "");
    course.write("assignments/06-rotation/Rotation.cpp", "");
    EXPECT_THAT(complaints(atHome()),
                ElementsAre("Camera.cpp is missing; camera.cpp is another: rename it",
                            "rotation.cpp is missing; Rotation.cpp is another: rename it"));
}

TEST_F(Collecting, TheFolderOfOneAssignmentNeedsNoOther) {
    const Collected all = collect(course.path(), manifest, {manifest.folder, false});
    EXPECT_THAT(all.unreadable, IsEmpty());
    EXPECT_EQ(staged(all, "rotation.cpp"), "starter rotation (starter)");
}

TEST_F(Collecting, AHeaderOfOnesOwnIsNoticedWhetherItIsTakenOrNot) {
    const std::string own =
        "#include <cmath>\n#include \"Camera.h\"\n#include \"scene.h\"\n#include \"mine.h\"\n";
    const auto notice = ElementsAre(
        "Camera.cpp includes mine.h, which is none of the files to hand in: write what it holds "
        "into Camera.cpp");
    course.write("assignments/07-camera/harness.cpp", "#include \"scene.h\"\n");
    submit("Camera.h", "mine h");
    submit("Camera.cpp", own);
    submit("scene.h", "our scene.h");
    EXPECT_THAT(collected().notices, IsEmpty()) << "there is no mine.h: the compiler says it";
    submit("mine.h", "");
    EXPECT_EQ(staged(collected(), "mine.h"), "nothing");
    EXPECT_THAT(collected().notices, notice);
    course.write("assignments/07-camera/Camera.cpp", own);
    course.write("assignments/07-camera/mine.h", "");
    course.write("assignments/07-camera/mine.cpp", "#include \"mine.h\"\n");
    EXPECT_THAT(atHome().notices, notice);
}

TEST_F(Collecting, FilesInFoldersOfTheManifestAreTaken) {
    manifest.submit = {"shaders/p.frag"};
    course.write("assignments/07-camera/shaders/p.frag", "starter frag");
    submit("shaders/p.frag", "mine");
    const Collected all = collected();
    EXPECT_EQ(staged(all, "shaders/p.frag"), "mine (submission)");
    EXPECT_THAT(all.ignored, IsEmpty());
}

TEST_F(Collecting, AFileMayLieAboveTheFolderThatItBelongsIn) {
    manifest.submit = {"shaders/p.frag"};
    course.write("assignments/07-camera/shaders/p.frag", "starter frag");
    submit("p.frag", "mine");
    const Collected all = collected();
    EXPECT_EQ(staged(all, "shaders/p.frag"), "mine (submission)");
    EXPECT_THAT(all.notices, ElementsAre("p.frag is taken as shaders/p.frag"));
    EXPECT_THAT(all.ignored, IsEmpty());
    submit("shaders/p.frag", "in its place");
    EXPECT_EQ(staged(collected(), "shaders/p.frag"), "in its place (submission)");
    EXPECT_THAT(collected().ignored, ElementsAre("p.frag"));
}

TEST_F(Collecting, ANameInOtherLettersIsToBeRenamed) {
    submit("camera.H", "mine h");
    submit("Camera.cpp", "mine cpp");
    const Collected all = collected();
    EXPECT_EQ(staged(all, "Camera.h"), "starter Camera.h (starter)");
    EXPECT_THAT(all.notices,
                ElementsAre("Camera.h is missing: graded with the starter's file; camera.H is "
                            "another: rename it"));
}

TEST_F(Collecting, MarksAndCarriageReturnsAreTakenOut) {
    submit("Camera.h", "\xEF\xBB\xBFone\r\ntwo\r\n");
    submit("Camera.cpp", "a\rb\r\r\n\xC3\xA9");
    const Collected all = collected();
    EXPECT_EQ(all.stage.find("Camera.h")->content, "one\ntwo\n");
    EXPECT_EQ(all.stage.find("Camera.cpp")->content, "a\rb\r\n\xC3\xA9");
    EXPECT_THAT(all.unreadable, IsEmpty());
}

TEST_F(Collecting, AnotherEncodingIsNamedWithItsLine) {
    submitBoth();
    submit("Camera.cpp",
           "one\n// Gr\xFC\xDF"
           "e\n");
    EXPECT_EQ(complaint(),
              "Camera.cpp:2: the file is not UTF-8 (byte 0xFC): save it with the encoding UTF-8");
    submit("Camera.cpp", std::string("\xFF\xFEi\0n\0t\0", 8));
    EXPECT_THAT(complaint(), HasSubstr("Camera.cpp:1: the file is not UTF-8 (byte 0xFF)"));
    submit("Camera.cpp", std::string("i\0n\0t\0", 6));
    EXPECT_THAT(complaint(), HasSubstr("Camera.cpp:1: the file is not UTF-8 (byte 0x00)"));
}

TEST_F(Collecting, AFolderInPlaceOfAFile) {
    submitBoth();
    fs::remove(hand / "07-camera/Camera.cpp");
    fs::create_directories(hand / "07-camera/Camera.cpp");
    EXPECT_EQ(complaint(), "Camera.cpp: expected a file, found a folder");
}

TEST_F(Collecting, ALinkIsNotFollowed) {
    submitBoth();
    const fs::path file = hand / "07-camera/Camera.cpp";
    const fs::path secret = course.write("solutions/07-camera/Camera.cpp", "solved");
    for (const fs::path& target : {secret, fs::path("/nonexistent"), file, course.path()}) {
        fs::remove(file);
        fs::create_symlink(target, file);
        EXPECT_EQ(complaint(), "Camera.cpp: expected a file, found a link: copy what it points to")
            << target;
    }
}

TEST_F(Collecting, ALinkedFolderIsNotFollowedEither) {
    course.write("solutions/07-camera/Camera.cpp", "solved");
    course.write("solutions/07-camera/Camera.h", "solved");
    fs::create_directory_symlink(course / "solutions/07-camera", hand / "07-camera");
    const Collected all = collected();
    EXPECT_EQ(all.unreadable.size(), 2u);
    EXPECT_EQ(staged(all, "Camera.cpp"), " (submission)");
}

TEST_F(Collecting, WhatIsBehindALinkedFolderIsNotNamed) {
    fs::create_directories(hand / "06-rotation");
    fs::create_symlink("/etc", hand / "07-camera");
    EXPECT_THAT(collected().ignored, IsEmpty());
}

TEST_F(Collecting, AFolderThatLinksToItselfIsALink) {
    fs::create_directories(hand / "06-rotation");
    fs::create_symlink("07-camera", hand / "07-camera");
    const Collected all = collected();
    ASSERT_FALSE(all.unreadable.empty());
    EXPECT_THAT(all.unreadable[0].message, HasSubstr("found a link"));
}

TEST_F(Collecting, LinksInACircleAmongTheOtherFilesAreNamedOnly) {
    submitBoth();
    fs::create_symlink("loop", hand / "07-camera/loop");
    EXPECT_THAT(collected().ignored, ElementsAre("loop"));
}

TEST_F(Collecting, APipeIsNotOpened) {
    submitBoth();
    fs::remove(hand / "07-camera/Camera.cpp");
    ASSERT_EQ(mkfifo((hand / "07-camera/Camera.cpp").c_str(), 0644), 0);
    EXPECT_EQ(complaint(), "Camera.cpp: expected a file, found something else");
}

TEST_F(Collecting, HeadersGoWithTheirSources) {
    course.write("assignments/06-rotation/rotation.h", "starter h");
    course.write("solutions/06-rotation/rotation.h", "solved h");
    course.write("solutions/06-rotation/rotation.cpp", "solved cpp");
    manifest.inherits["rotation.h"] = "06-rotation";
    submitBoth();
    hand.write("06-rotation/rotation.h", "mine h");
    const Collected without = collected();
    EXPECT_EQ(staged(without, "rotation.cpp"), "solved cpp (solutions)");
    EXPECT_EQ(staged(without, "rotation.h"), "solved h (solutions)");
    EXPECT_THAT(without.notices,
                ElementsAre("rotation.h of 06-rotation is not used without rotation.cpp"));

    hand.write("06-rotation/rotation.cpp", "mine cpp");
    const Collected with = collected();
    EXPECT_EQ(staged(with, "rotation.h"), "mine h (submission)");
    EXPECT_THAT(with.notices, IsEmpty());
    ASSERT_EQ(with.stage.coursesHeaders.size(), 1u);
    EXPECT_EQ(with.stage.coursesHeaders[0].content, "solved h");
}

TEST_F(Collecting, AVeryLargeFileIsRefused) {
    submitBoth();
    fs::resize_file(hand / "07-camera/Camera.cpp", (4u << 20) + 1);
    EXPECT_EQ(complaint(), "Camera.cpp: the file is larger than 4 MiB");
}

TEST_F(Collecting, AnUnreadableFileIsNamed) {
    submitBoth();
    fs::permissions(hand / "07-camera/Camera.cpp", fs::perms::none);
    const AsNobody other;
    ASSERT_TRUE(other.worked());
    EXPECT_EQ(complaint(), "Camera.cpp: the file cannot be read: check its permissions");
}

TEST_F(Collecting, AnUnreadableCopyOfOurFileIsNamedOnly) {
    submitBoth();
    submit("README.md", "our README.md");
    fs::permissions(hand / "07-camera/README.md", fs::perms::none);
    const AsNobody other;
    ASSERT_TRUE(other.worked());
    EXPECT_THAT(collected().ignored, ElementsAre("README.md"));
}

TEST_F(Collecting, AnInheritedFileInTheAssignmentsOwnFolderIsTakenOnceAndAsTheStudents) {
    course.write("assignments/07-camera/rotation.cpp", "a copy");
    const Collected all = atHome();
    EXPECT_EQ(std::count_if(all.stage.files.begin(), all.stage.files.end(),
                            [](const StagedFile& file) { return file.name == "rotation.cpp"; }),
              1);
    EXPECT_EQ(all.stage.find("rotation.cpp")->role, Role::inherited);
    // It is not handed to others as the assignment's own.
    submitBoth();
    EXPECT_EQ(staged(collected(), "rotation.cpp"), "starter rotation (starter)");
}

}  // namespace
