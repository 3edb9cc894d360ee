// Input that is not as it should be: each case has a message that a first-year student can act on.

#include <algorithm>
#include <cstdlib>

#include "CourseCopy.h"
#include "Lab.h"

namespace {

using lab::Graded;
using lab::Json;
using lab::Submission;

const std::string kRotation = "06-rotation/rotation.cpp";

testing::AssertionResult says(const Graded& graded, const std::string& part) {
    if (graded.text.find(part) != std::string::npos)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "expected \"" << part << "\" in:\n" << graded.text;
}

const Json& firstDiagnostic(const Graded& graded) {
    return graded.document.at("build").at("diagnostics").at(0);
}

TEST(BadInput, AnUnknownAssignmentListsTheKnownOnes) {
    const Graded graded = lab::runGrader({"07-kamera"});
    EXPECT_EQ(graded.exitCode, 2);
    EXPECT_TRUE(says(graded, "07-kamera"));
    EXPECT_TRUE(says(graded, "06-rotation, 07-camera, 08-perspective"));
}

TEST(BadInput, AMissingSubmissionFolderIsNamed) {
    const Graded graded = lab::runGrader({"--submission", "/nonexistent/folder"});
    EXPECT_EQ(graded.exitCode, 2);
    EXPECT_TRUE(says(graded, "/nonexistent/folder: there is no such folder"));
}

TEST(BadInput, ASingleFileIsNoSubmission) {
    const Submission submission;
    const Graded graded =
        lab::runGrader({"06-rotation", "--submission", submission.file(kRotation).string()});
    EXPECT_EQ(graded.exitCode, 2);
    EXPECT_TRUE(says(graded, "expected a folder or an archive; put the file into a folder"));
}

TEST(BadInput, TheCommandForPicturesNamesTheSameSubmission) {
    const lab::WorkFolder work;
    const std::string folder = work.path().string();
    lab::writeFile(folder + "/Mia's files/rotation.cpp", "this is no C++\n");
    const Graded graded = lab::runGrader({"--context", "osmesa", "--submission",
                                          folder + "/Mia's files", "--seed", "7", "06-rotation"});
    EXPECT_TRUE(says(graded, "\nPictures: ./grade --open 06-rotation --submission '" + folder +
                                 "/Mia'\\''s files' --seed 7 --context osmesa\n"));
}

TEST(BadInput, AMissingFileIsNamedAndTheRestIsGraded) {
    Submission submission;
    lab::fs::remove(submission.file("08-perspective/projection.cpp"));
    const Graded graded = submission.grade("08-perspective");
    EXPECT_TRUE(graded.notes("projection.cpp is missing"));
    EXPECT_EQ(graded.task("perspective").at("status"), "pass");
    EXPECT_EQ(graded.task("orthographic").at("status"), "not_implemented");
}

TEST(BadInput, AFileThatIsNotUtf8IsNamedWithItsLine) {
    Submission submission;
    submission.write(kRotation, "// f\xfcr\n" + submission.read(kRotation));
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 1);
    EXPECT_EQ(graded.document.at("status"), "build_error");
    EXPECT_EQ(firstDiagnostic(graded).at("file"), "rotation.cpp");
    EXPECT_EQ(firstDiagnostic(graded).at("line"), 1);
    EXPECT_TRUE(says(graded, "save it with the encoding UTF-8"));
}

TEST(BadInput, AFolderInPlaceOfAFileIsNamed) {
    Submission submission;
    lab::fs::remove(submission.file(kRotation));
    lab::fs::create_directory(submission.file(kRotation));
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 1);
    EXPECT_TRUE(says(graded, "expected a file, found a folder"));
}

TEST(BadInput, CarriageReturnsAndAByteOrderMarkAreAccepted) {
    Submission submission;
    submission.replace(kRotation, "\n", "\r\n");
    submission.write(kRotation, "\xEF\xBB\xBF" + submission.read(kRotation));
    EXPECT_EQ(submission.grade("06-rotation").points(), 100.0);
}

TEST(BadInput, ASyntaxErrorHasTheStudentsOwnFileAndLine) {
    Submission submission;
    submission.write(kRotation, submission.read(kRotation) + "int five = 5\nint six = 6;\n");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 1);
    EXPECT_EQ(graded.document.at("status"), "build_error");
    EXPECT_EQ(graded.points(), 0.0);
    EXPECT_EQ(firstDiagnostic(graded).at("file"), "rotation.cpp");
    EXPECT_EQ(firstDiagnostic(graded).at("severity"), "error");
    EXPECT_GT(firstDiagnostic(graded).at("line"), 0);
    EXPECT_EQ(graded.status("turned"), "build_error");
    EXPECT_FALSE(says(graded, "/tmp/"));
}

TEST(BadInput, ZNearForNearGetsAHint) {
    for (const char* name : {"zNear", "nearDist"}) {
        Submission submission;
        submission.replace("07-camera/Camera.h", "float near;", std::string("float ") + name + ";");
        submission.replace("07-camera/Camera.cpp", "    near = near_default;\n", "");
        submission.replace("07-camera/Camera.cpp", "near", name);
        const Graded graded =
            lab::runGrader({"07-camera", "--submission", submission.folder().string()});
        EXPECT_EQ(graded.exitCode, 1);
        EXPECT_TRUE(says(graded, "no member named 'near'"));
        EXPECT_TRUE(says(graded, "windows.h"));
    }
}

TEST(BadInput, AHeadersNameInOtherCaseIsExplained) {
    for (const auto& [right, wrong] :
         {std::pair{"Camera.h", "camera.h"}, {"cg/Todo.h", "cg/todo.h"}}) {
        Submission submission;
        submission.write("07-camera/Camera.cpp", fmt::format("#include \"{}\"\n", wrong) +
                                                     submission.read("07-camera/Camera.cpp"));
        const std::string message = firstDiagnostic(submission.grade("07-camera")).at("message");
        EXPECT_EQ(message,
                  fmt::format("{}: No such file or directory, but there is {}", wrong, right));
    }
}

TEST(BadInput, WhatOtherSystemsLackIsNoticedAndCostsNothing) {
    Submission submission;
    submission.write(kRotation, "#include <cmath>\nstatic const double kPi = M_PI;\n" +
                                    submission.read(kRotation) +
                                    "double halfTurn() { return kPi; }\n");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.points(), 100.0);
    EXPECT_TRUE(graded.notes("rotation.cpp uses M_PI"));
}

TEST(BadInput, TheTerminalShowsTheErrorAndFitsEightyColumns) {
    Submission submission;
    submission.solve(kRotation, "rotation", "    return undefinedThing;\n");
    const Graded graded =
        lab::runGrader({"06-rotation", "--submission", submission.folder().string()});
    EXPECT_TRUE(says(graded, "rotation.cpp:"));
    EXPECT_TRUE(says(graded, "undefinedThing"));
}

TEST(BadInput, WhatKilledGradingsLeftBehindIsRemoved) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "a sanitizer's library wants to be loaded before any other";
#endif
    const lab::WorkFolder temporary;
    // They are old enough for a clock that jumps ahead at every second look.
    const std::vector<lab::fs::path> left = {temporary.path() / "course-aaaaaa",
                                             temporary.path() / "course-bbbbbb"};
    for (const lab::fs::path& each : left)
        lab::fs::create_directory(each);
    Submission submission;
    submission.write(kRotation, "this is no C++\n");
    const auto graded = lab::run(
        {"env", std::string("LD_PRELOAD=") + JUMPING_CLOCK, "TMPDIR=" + temporary.path().string(),
         COURSE_GRADER, "06-rotation", "--submission", submission.folder().string()},
        60);
    EXPECT_EQ(graded.exitCode, 1) << graded.output;
    EXPECT_FALSE(lab::fs::exists(left[0]) && lab::fs::exists(left[1]));
}

/// For damage that must not touch ours.
class DamagedCourse : public testing::Test {
protected:
    Graded grade(const std::string& assignment, const std::string& tree = "solutions",
                 const std::vector<std::string>& more = {}) {
        std::vector<std::string> command = {program_.string(), assignment, "--submission",
                                            file(tree).string()};
        command.insert(command.end(), more.begin(), more.end());
        const auto result = lab::run(command, 60.0);
        Graded graded;
        graded.exitCode = result.exitCode;
        graded.text = result.output;
        return graded;
    }
    lab::fs::path file(const std::string& name) { return copy_.root() / name; }
    void edit(const std::string& name, const std::string& from, const std::string& to) {
        std::string text = lab::readFile(file(name));
        const auto at = text.find(from);
        ASSERT_NE(at, std::string::npos) << name << ": " << from;
        lab::writeFile(file(name), text.replace(at, from.size(), to));
    }

    static void makeProgram(const lab::fs::path& at, const std::string& text) {
        lab::writeFile(at, "#!/bin/sh\n" + text);
        lab::fs::permissions(at, lab::fs::perms(0755));
    }
    /// Where programs of the test's own are found first.
    std::string path() { return "PATH=" + file("bin").string() + ":" + std::getenv("PATH"); }

    const lab::CourseCopy copy_;
    const lab::fs::path program_ = copy_.root() / "grade";
};

TEST_F(DamagedCourse, GradesWhenNothingIsDamaged) {
    EXPECT_EQ(grade("06-rotation").exitCode, 0);
}

TEST_F(DamagedCourse, AnUnknownManifestFieldIsNamedWithWhatIsAllowed) {
    edit("assignments/06-rotation/assignment.json", "\"chapter\"", "\"chaptre\": 1, \"chapter\"");
    const Graded graded = grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 2);
    EXPECT_TRUE(says(graded, "assignment.json"));
    EXPECT_TRUE(says(graded, "unknown field \"chaptre\"; allowed are chapter, "));
}

TEST_F(DamagedCourse, ANewerManifestIsRefused) {
    edit("assignments/06-rotation/assignment.json", "\"format\": 1", "\"format\": 2");
    const Graded graded = grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 2);
    EXPECT_TRUE(says(graded, "expected 1, found 2"));
}

TEST_F(DamagedCourse, AReferenceOfTheWrongSizeIsNamedWithTheCommandThatMendsIt) {
    edit("assignments/06-rotation/assignment.json", "[400, 300]", "[320, 240]");
    const Graded graded = grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 2);
    EXPECT_TRUE(says(graded, "expected 320 x 240 pixels, found 400 x 300"));
    EXPECT_TRUE(says(graded, "./grade update-references 06-rotation"));
}

TEST_F(DamagedCourse, AMissingReferenceIsNamed) {
    lab::fs::remove(file("reference_images/06-rotation/turned.png"));
    const Graded graded = grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 2);
    EXPECT_TRUE(says(graded, "turned.png is missing"));
}

TEST_F(DamagedCourse, WithoutSolutionsOnlyThePublishedSeedIsGraded) {
    lab::fs::rename(file("solutions"), file("handed-in"));
    EXPECT_EQ(grade("06-rotation", "handed-in").exitCode, 0);
    const auto other = lab::run({program_.string(), "06-rotation", "--submission",
                                 file("handed-in").string(), "--seed", "5"},
                                60.0);
    EXPECT_EQ(other.exitCode, 2);
    EXPECT_NE(other.output.find("seed 5 needs solutions/06-rotation"), std::string::npos);
}

TEST_F(DamagedCourse, WithoutSolutionsWhatRestsOnALostTaskIsSkipped) {
    lab::fs::rename(file("solutions"), file("handed-in"));
    edit("handed-in/06-rotation/rotation.cpp", "return R;", "return glm::transpose(R);");
    const Graded graded = grade("07-camera", "handed-in");
    EXPECT_EQ(graded.exitCode, 1);
    EXPECT_TRUE(says(graded, "rests on 06-rotation/rotation, which loses points itself"));
    edit("handed-in/06-rotation/rotation.cpp", "return glm::transpose(R);", "return R;");
    edit("handed-in/07-camera/Camera.cpp", "rotation(degrees, up)", "rotation(-degrees, up)");
    const Graded own = grade("07-camera", "handed-in");
    EXPECT_FALSE(says(own, "rests on"));
}

TEST_F(DamagedCourse, WithoutSolutionsWhatDoesWithoutALostTaskIsJudged) {
    lab::fs::rename(file("solutions"), file("handed-in"));
    const std::string rotation = "handed-in/06-rotation/rotation.cpp";
    edit(rotation, "u.z, -u.y)", "u.z, u.y)");
    edit(rotation, "0.5f * glm::radians(degrees)", "glm::radians(degrees)");
    EXPECT_FALSE(says(grade("06-rotation", "handed-in"), "rests on"))
        << "eulerRodrigues has a mistake of its own";
    edit(rotation, "return R;\n    // END TODO(euler-rodrigues)",
         "return R + 0.0f * crossMatrix(axis);\n    // END TODO(euler-rodrigues)");
    EXPECT_TRUE(says(grade("06-rotation", "handed-in"), "rests on cross-matrix"));
}

TEST_F(DamagedCourse, WhatAVariantLosesIsAnArray) {
    lab::writeFile(file("solutions/06-rotation/variants/a/loses.json"), "{}");
    const auto checked = lab::run({program_.string(), "check-course", "06-rotation"}, 120.0);
    EXPECT_EQ(checked.exitCode, 2);
    EXPECT_NE(checked.output.find("variants/a/loses.json: expected an array, each element a text, "
                                  "found {}"),
              std::string::npos)
        << checked.output;
}

TEST_F(DamagedCourse, AWindowIsBuiltByOneAtATimeAndOpenedForAll) {
    // In place of CMake and of a window: who says whether somebody else could build.
    const std::string ifFree = "flock -n '" + (copy_.build() / "lock").string() + "' ";
    makeProgram(file("bin/cmake"), ifFree + "echo free while it is built\nexit 0\n");
    makeProgram(copy_.build() / "windows/06-rotation", ifFree + "echo free while it is open\n");
    const auto opened = lab::run({"env", path(), program_.string(), "window", "06-rotation"}, 60.0);
    EXPECT_EQ(opened.output, "free while it is open\n");
}

TEST_F(DamagedCourse, ADebuggerIsToldWhereTheTaskIs) {
    makeProgram(file("bin/cmake"), "");
    makeProgram(file("bin/gdb"), "printf %s \"$3\"\n");
    for (const std::string id : {"06-rotation", "10-lighting"})
        makeProgram(copy_.build() / "debug" / (id + "_debug"), "echo '  AnyTest'\n");
    const auto toldFor = [&](const std::string& id, const std::string& test) {
        return lab::run({"env", path(), program_.string(), "debug", id, test}, 60.0).output;
    };
    const std::string rotation = lab::readFile(file("assignments/06-rotation/rotation.cpp"));
    const auto line = std::count(
        rotation.begin(), rotation.begin() + long(rotation.find("// BEGIN TODO(rotation)")), '\n');
    EXPECT_EQ(toldFor("06-rotation", "Rotation.Zero"),
              fmt::format("echo Set a breakpoint (break rotation.cpp:{}), then: run\\n", line + 1));
    EXPECT_EQ(toldFor("10-lighting", "Ambient.Any"), "echo Set a breakpoint, then: run\\n")
        << "it is in a shader";
}

TEST_F(DamagedCourse, AMissingFileOfTheStudentsKeepsOnlyWhatIsMadeOfIt) {
    const lab::fs::path rotation = file("assignments/06-rotation/rotation.cpp");
    lab::fs::rename(rotation, file("kept"));
    const std::string mend = "rotation.cpp is missing: git restore ";
    const Graded lost = grade("07-camera", "assignments");
    EXPECT_EQ(lost.exitCode, 1);
    EXPECT_TRUE(says(lost, mend));
    EXPECT_FALSE(says(lost, "compile")) << lost.text;
    EXPECT_EQ(grade("08-perspective").exitCode, 0) << "others are graded as ever";
    const auto window = lab::run({program_.string(), "window", "06-rotation"}, 60.0);
    EXPECT_EQ(
        window.output,
        "grade: " + mend + "assignments/06-rotation/rotation.cpp brings the starter's back\n");

    const std::string without = copy_.buildAssignment("help").output;
    EXPECT_NE(without.find("\n06-rotation_tests: "), std::string::npos) << without;
    EXPECT_EQ(without.find("\n06-rotation_debug: "), std::string::npos) << without;
    EXPECT_EQ(without.find("\n08-perspective: "), std::string::npos) << without;
    lab::fs::rename(file("kept"), rotation);
    const std::string again = copy_.sh("cmake --build build/release --target help").output;
    EXPECT_NE(again.find("\n06-rotation_debug: "), std::string::npos) << again;
    EXPECT_NE(again.find("\n08-perspective: "), std::string::npos) << again;
}

TEST_F(DamagedCourse, ACopyOfAnAssignmentIsLeftOut) {
    lab::fs::copy(file("assignments/06-rotation"), file("assignments/06-rotation (copy)"),
                  lab::fs::copy_options::recursive);
    const std::string sentence =
        "assignments/06-rotation (copy) is a copy of 06-rotation, left out";
    const Graded graded = grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 0);
    EXPECT_TRUE(says(graded, sentence));
    EXPECT_EQ(copy_.buildAssignment("help").exitCode, 0);
    EXPECT_NE(lab::readFile(file("configure.log")).find(sentence), std::string::npos);
}

/// A course whose runner and compiler are started by scripts of the test's own. They find the kit
/// in $kit, and may write to $kit/seen.
class DamagedMachine : public DamagedCourse {
protected:
    DamagedMachine() {
        const lab::fs::path ours = lab::fs::canonical(kit());
        lab::fs::remove(kit());
        lab::fs::copy(ours, kit(), lab::fs::copy_options::recursive);
        lab::fs::create_directory(seen());
        lab::fs::permissions(seen(), lab::fs::perms(0777));
        // Without a sandbox they leave their traces there: nothing holds them to files of their
        // own.
        lab::fs::rename(kit() / "bin/confine", kit() / "bin/confine.real");
        script("confine",
               "for word; do shift; case $word in read=* | write=*) ;;\n"
               "*) set -- \"$@\" \"$word\" ;; esac; done\n"
               "exec $kit/bin/confine.real \"$@\"\n");
    }
    lab::fs::path kit() const { return copy_.build() / "kit"; }
    lab::fs::path seen() const { return kit() / "seen"; }
    lab::fs::path script(const std::string& name, const std::string& text) const {
        const lab::fs::path file = kit() / "bin" / name;
        lab::writeFile(file, "#!/bin/sh\nkit='" + kit().string() + "'\n" + text);
        lab::fs::permissions(file, lab::fs::perms(0755));
        return file;
    }
    void startRunnerBy(const std::string& text) const {
        lab::fs::rename(kit() / "bin/runner", kit() / "bin/runner.real");
        script("runner", text);
    }
    enum class Which { ofTheFirstBuild, ofAllOthers };
    /// These runners do something else in place of their work.
    void spoilRunners(Which which, const std::string& instead) const {
        startRunnerBy(
            "[ -e $kit/seen/first ] || echo \"$1\" > $kit/seen/first\n"
            "[ \"$(cat $kit/seen/first)\" " +
            std::string(which == Which::ofTheFirstBuild ? "!=" : "=") + " \"$1\" ] || " + instead +
            "\nexec $kit/bin/runner.real \"$@\"\n");
    }
    void expectNoPointsLost() {
        const Graded graded = grade("06-rotation", "solutions", {"--no-sandbox"});
        EXPECT_TRUE(lab::fs::exists(seen() / "first")) << "nothing was spoilt";
        EXPECT_EQ(graded.exitCode, 0) << graded.text;
        EXPECT_TRUE(says(graded, "100 / 100"));
    }
    void startCompilerBy(const std::string& text) const {
        const lab::fs::path file = copy_.build() / "grader/toolchain.json";
        Json tools = lab::parseJsonFile(file.string());
        tools["compiler"] = script("compiler", text).string();
        lab::writeFile(file, tools.dump());
    }
};

TEST_F(DamagedMachine, WithoutAGlLibraryTheMessageSaysWhatToInstall) {
    // Broken libraries only, as on a machine that has none.
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libEGL.so.1"})
        lab::writeFile(kit() / "broken" / name, "no library");
    startRunnerBy("LD_LIBRARY_PATH=$kit/broken exec $kit/bin/runner.real \"$@\"\n");
    const Graded graded = grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 2);
    EXPECT_TRUE(says(graded, "install libosmesa6"));
    EXPECT_TRUE(says(graded, "that is not your mistake"));
}

TEST_F(DamagedMachine, ARunnerThatFailsForAWhileCostsNoPoints) {
    spoilRunners(Which::ofTheFirstBuild, "exit 3");  // as on a machine that is short of processes
    expectNoPointsLost();
}

TEST_F(DamagedMachine, ARunnerThatIsKilledForAWhileCostsNoPoints) {
    spoilRunners(Which::ofTheFirstBuild, "kill -9 $$");  // as the kernel does, short of memory
    expectNoPointsLost();
}

TEST_F(DamagedMachine, AFaultWhileANeededTaskIsPutRightTakesNoPoints) {
    // The submission itself is graded; all that is graded after it fails.
    spoilRunners(Which::ofAllOthers, "exit 3");
    lab::fs::copy(file("solutions"), file("handed-in"), lab::fs::copy_options::recursive);
    edit("handed-in/06-rotation/rotation.cpp", "return R;", "return glm::transpose(R);");
    const Graded graded = grade("07-camera", "handed-in", {"--no-sandbox"});
    EXPECT_EQ(graded.exitCode, 2) << graded.text;
    EXPECT_TRUE(says(graded, "that is not your mistake")) << graded.text;
}

TEST_F(DamagedMachine, ACompilerThatIsKilledForAWhileCostsNoPoints) {
    startCompilerBy("mkdir $kit/seen/killed 2> /dev/null && kill -9 $$\nexec c++ \"$@\"\n");
    const Graded graded = grade("06-rotation", "solutions", {"--no-sandbox"});
    EXPECT_TRUE(lab::fs::exists(seen() / "killed")) << "nothing was killed";
    EXPECT_EQ(graded.exitCode, 0) << graded.text;
    EXPECT_TRUE(says(graded, "100 / 100"));
}

TEST_F(DamagedMachine, ACompilerThatIsKilledAlwaysIsNotTheSubmissionsFault) {
    startCompilerBy("kill -9 $$\n");
    const Graded graded = grade("06-rotation", "solutions", {"--no-sandbox"});
    EXPECT_EQ(graded.exitCode, 2) << graded.text;
    EXPECT_TRUE(says(graded, "nothing can be compiled on this machine"));
}

}  // namespace
