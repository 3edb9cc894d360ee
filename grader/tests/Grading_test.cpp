// What students and instructors rely on, from a submission's files to the result document.

#include <sys/stat.h>
#include <unistd.h>

#include "Lab.h"

namespace {

using lab::Graded;
using lab::Json;
using lab::Submission;
using Ids = std::vector<std::string>;

const std::string kRotation = "06-rotation/rotation.cpp";
const std::string kCamera = "07-camera/Camera.cpp";

TEST(Grading, SolutionsEarnEverything) {
    const Graded graded =
        lab::runGrader({"--submission", (lab::root() / "solutions").string(), "--json", "-"});
    EXPECT_EQ(graded.exitCode, 0);
    ASSERT_TRUE(graded.document.is_array()) << graded.text;
    ASSERT_GE(graded.document.size(), 3u);
    for (const Json& each : graded.document)
        EXPECT_EQ(each.at("points"), each.at("max_points")) << each.at("assignment");
}

TEST(Grading, StartersEarnNothingAndAreNotImplemented) {
    const Graded graded =
        lab::runGrader({"--submission", (lab::root() / "assignments").string(), "--json", "-"});
    EXPECT_EQ(graded.exitCode, 1);
    ASSERT_GE(graded.document.size(), 3u);
    for (const Json& each : graded.document) {
        EXPECT_EQ(each.at("points"), 0.0);
        for (const Json& task : each.at("tasks"))
            EXPECT_EQ(task.at("status"), "not_implemented")
                << each.at("assignment") << task.at("id");
    }
}

TEST(Grading, TwoRunsDifferInTimingOnly) {
    const Submission submission;
    Json first = submission.grade("07-camera").document;
    Json second = submission.grade("07-camera").document;
    first.erase("timing");
    second.erase("timing");
    EXPECT_EQ(first.dump(), second.dump());
    EXPECT_FALSE(first.dump().empty());
}

/// Which file each object in the cache is, by key: one that is made again is another one.
std::map<std::string, ino_t> cachedObjects() {
    const lab::fs::path toolchain = lab::fs::path(COURSE_GRADER).parent_path() / "toolchain.json";
    const lab::fs::path cache =
        lab::fs::path(lab::parseJsonFile(toolchain.string()).at("build").get<std::string>()) /
        "cache/objects";
    std::map<std::string, ino_t> objects;
    for (const lab::fs::path& each : lab::entriesOf(cache)) {
        struct stat status {};
        if (stat((each / "object").c_str(), &status) == 0)
            objects[each.filename().string()] = status.st_ino;
    }
    return objects;
}

TEST(Grading, WhatWasCompiledBeforeIsNotCompiledAgain) {
    Submission submission;
    const std::string text =
        submission.read(kRotation) + "static int neverSeen" + std::to_string(getpid()) + ";  // ";
    submission.write(kRotation, text + "one comment\n");
    const auto before = cachedObjects();
    EXPECT_EQ(submission.grade("06-rotation").points(), 100.0);
    auto known = cachedObjects();
    std::erase_if(known, [&](const auto& each) { return before.contains(each.first); });
    EXPECT_GE(known.size(), 2u) << "its object and its program are kept";
    submission.write(kRotation, text + "another comment\n");
    EXPECT_EQ(submission.grade("06-rotation").points(), 100.0);
    const auto after = cachedObjects();
    for (const auto& [key, file] : known)
        EXPECT_TRUE(after.contains(key) && after.at(key) == file) << key << " was made again";
}

TEST(Grading, AnotherSeedDrawsItsReferencesFromTheSolution) {
    const Graded graded = Submission().grade("06-rotation", {"--seed", "77"});
    EXPECT_EQ(graded.exitCode, 0) << graded.text;
    EXPECT_EQ(graded.document.at("seed"), 77);
}

TEST(Grading, AFolderOfOneAssignmentNeedsItsName) {
    const Submission submission;
    const std::string folder = (submission.folder() / "06-rotation").string();
    const Graded unnamed = lab::runGrader({"--submission", folder});
    EXPECT_EQ(unnamed.exitCode, 2);
    EXPECT_NE(unnamed.text.find("name that assignment"), std::string::npos) << unnamed.text;
    EXPECT_EQ(lab::runGrader({"06-rotation", "--submission", folder}).exitCode, 0);
}

TEST(Grading, PicturesInTheTerminalAreRefusedInOneLineWhereNobodySeesThem) {
    const Graded graded = lab::runGrader({"06-rotation", "--images"});
    EXPECT_TRUE(graded.text.starts_with("No pictures are shown, because")) << graded.text;
    EXPECT_EQ(graded.text.find("▀"), std::string::npos);
}

TEST(Grading, TheHelpShowsHowToGrade) {
    const Graded help = lab::runGrader({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    for (const char* part :
         {"./grade 06-rotation", "--watch", "--open", "--yes", "./grade grade --help"})
        EXPECT_NE(help.text.find(part), std::string::npos) << part << help.text;
}

TEST(Grading, AnErrorInAHeaderIsSaidOnce) {
    Submission submission;
    const std::string header = "07-camera/Camera.h";
    submission.write(header, submission.read(header) + "\n#error twice\n");
    const Graded graded = submission.grade("07-camera");
    const Json& diagnostics = graded.document.at("build").at("diagnostics");
    ASSERT_EQ(diagnostics.size(), 1u) << "though several files include it";
    EXPECT_EQ(diagnostics[0].at("message"), "#error twice");
}

TEST(Grading, AnErrorHasItsSourceLine) {
    Submission submission;
    submission.write(kCamera, "#error mine\n" + submission.read(kCamera));
    const Json own = submission.grade("07-camera").document.at("build").at("diagnostics").at(0);
    EXPECT_EQ(own.at("source"), "#error mine");
    EXPECT_EQ(own.at("column"), 2);
}

TEST(Grading, ACrashCostsOnlyTheChecksThatCallIt) {
    Submission submission;
    submission.solve(
        kRotation, "euler-rodrigues",
        "    volatile int* nowhere = nullptr;\n    return glm::mat3(float(*nowhere));\n");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.losses(), Ids{"euler-rodrigues"});
    const std::string message = graded.message("EulerRodrigues.ImageOfAVector");
    EXPECT_EQ(graded.status("EulerRodrigues.ImageOfAVector"), "crash");
    EXPECT_NE(message.find("SIGSEGV"), std::string::npos) << message;
    EXPECT_NE(message.find("eulerRodrigues"), std::string::npos) << message;
    EXPECT_NE(message.find("rotation.cpp:"), std::string::npos) << message;
}

TEST(Grading, EndlessRecursionIsLocated) {
    Submission submission;
    submission.solve(kRotation, "cross-matrix", "    return crossMatrix(u) + glm::mat3(u.x);\n");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.losses(), Ids{"cross-matrix"});
    EXPECT_NE(graded.message("CrossMatrix.OneTwoThree").find("crossMatrix, rotation.cpp:"),
              std::string::npos)
        << graded.message("CrossMatrix.OneTwoThree");
}

TEST(Grading, ExitCostsOnlyTheChecksThatCallIt) {
    Submission submission;
    submission.solve(kRotation, "euler-rodrigues", "    std::exit(0);\n");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.losses(), Ids{"euler-rodrigues"});
    EXPECT_EQ(graded.status("EulerRodrigues.ImageOfAVector"), "tampered");
}

TEST(Grading, AnEndlessLoopCostsOneTimeOut) {
    Submission submission;
    submission.solve(kRotation, "euler-rodrigues", "    for (volatile int i = 0;; i = i + 1) {}\n");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.losses(), Ids{"euler-rodrigues"});
    EXPECT_EQ(graded.status("EulerRodrigues.ImageOfAVector"), "timeout");
    EXPECT_EQ(graded.status("three-bodies"), "timeout");
}

TEST(Grading, AnExceptionIsQuoted) {
    Submission submission;
    submission.solve(kRotation, "euler-rodrigues", "    throw std::runtime_error(\"no axis\");\n");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.losses(), Ids{"euler-rodrigues"});
    EXPECT_NE(graded.message("EulerRodrigues.ImageOfAVector").find("no axis"), std::string::npos);
}

TEST(Grading, WhatAFrameNeitherClearsNorDrawsIsSaid) {
    Submission submission;
    submission.replace(kRotation, "// BEGIN TODO(rotation)\n",
                       "// BEGIN TODO(rotation)\n    if (glEnable) {\n        glEnable(0x0C11);\n"
                       "        glScissor(0, 0, 40, 30);\n    }\n");
    submission.write(kRotation,
                     "extern \"C\" __attribute__((weak)) void glEnable(unsigned);\n"
                     "extern \"C\" __attribute__((weak)) void glScissor(int, int, int, int);\n" +
                         submission.read(kRotation));
    const Graded graded = submission.grade("06-rotation");
    const std::string message = graded.message("turned");
    EXPECT_NE(message.find("99.0 % of the picture was neither cleared nor drawn"),
              std::string::npos)
        << message;
    EXPECT_EQ(graded.status("whirl"), "pass") << "the next frame begins anew";
}

TEST(Grading, AStaticInitialiserThatCrashesIsTheSubmissionsFault) {
    Submission submission;
    submission.write(kRotation,
                     submission.read(kRotation) +
                         "\nstatic const int early = [] { std::abort(); return 1; }();\n");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.exitCode, 1) << graded.text;
    EXPECT_EQ(graded.points(), 0.0);
    EXPECT_EQ(graded.status("CrossMatrix.OneTwoThree"), "crash");
}

TEST(Grading, AFloodOfOutputIsStopped) {
    Submission submission;
    submission.solve(kRotation, "euler-rodrigues",
                     "    for (;;) std::cout << \"turning and turning\\n\";\n");
    EXPECT_EQ(submission.grade("06-rotation").status("EulerRodrigues.ImageOfAVector"), "output");
}

TEST(Grading, TooMuchMemoryIsNamed) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer's allocator ends the process where memory runs out";
#endif
    Submission submission;
    submission.solve(kRotation, "euler-rodrigues",
                     "    std::vector<float> all(std::size_t(1) << 40);\n"
                     "    return glm::mat3(all[7]);\n");
    EXPECT_EQ(submission.grade("06-rotation").status("EulerRodrigues.ImageOfAVector"), "memory");
}

TEST(Grading, AFunctionThatIsMissingCostsItsTaskOnly) {
    Submission submission;
    submission.replace(kRotation,
                       "glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {",
                       "glm::mat3 eulerRodriguez(const float degrees, const glm::vec3 axis) {");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.losses(), Ids{"euler-rodrigues"});
    EXPECT_EQ(graded.task("euler-rodrigues").at("status"), "not_implemented");
    EXPECT_NE(graded.message("EulerRodrigues.ImageOfAVector")
                  .find("`eulerRodrigues(float, glm::vec3)` is defined in none"),
              std::string::npos)
        << graded.message("EulerRodrigues.ImageOfAVector");
}

TEST(Grading, AWrongSignatureShowsBoth) {
    Submission submission;
    submission.replace(kRotation,
                       "glm::mat3 eulerRodrigues(const float degrees, const glm::vec3 axis) {",
                       "glm::mat3 eulerRodrigues(const double degrees, const glm::vec3 axis) {");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.losses(), Ids{"euler-rodrigues"});
    EXPECT_NE(graded.message("EulerRodrigues.ImageOfAVector")
                  .find("they define `eulerRodrigues(double, glm::vec3)`"),
              std::string::npos)
        << graded.message("EulerRodrigues.ImageOfAVector");
}

TEST(Grading, AnUnresolvedSymbolOfTheStudentsOwnIsNamed) {
    Submission submission;
    submission.replace(kRotation, "glm::mat3 eulerRodrigues(",
                       "float half(float);\n\nglm::mat3 eulerRodrigues(");
    submission.solve(kRotation, "euler-rodrigues",
                     "    return glm::mat3(half(degrees) * axis.x);\n");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.losses(), Ids{"euler-rodrigues"});
    EXPECT_NE(graded.message("EulerRodrigues.ImageOfAVector").find("`half(float)`"),
              std::string::npos);
}

TEST(Grading, ASubmissionCannotReadRootsFilesOrForkWithoutEnd) {
    if (getuid() != 0)
        GTEST_SKIP() << "only root can make a file that the sandbox's user may not read";
    const lab::WorkFolder secret;
    const std::string file = (secret.path() / "secret").string();
    lab::writeFile(file, "secret");
    chmod(file.c_str(), 0600);
    Submission submission;
    const std::string guard =
        "    static bool read = bool(std::ifstream(\"" + file +
        "\")) || bool(std::ifstream(\"/etc/shadow\"));\n"
        "    int children = 0, child = 1;\n"
        "    while (children < 300 && (child = fork()) > 0) ++children;\n"
        "    if (child == 0) pause();\n"
        "    if (read || children == 300) throw std::runtime_error(\"open\");\n";
    submission.replace(kRotation, "#include <cmath>",
                       "#include <cmath>\n#include <fstream>\n#include <unistd.h>");
    const std::string solved = submission.read(kRotation);
    const auto at = solved.find("    const float half = 0.5f");
    ASSERT_NE(at, std::string::npos);
    submission.write(kRotation, solved.substr(0, at) + guard + solved.substr(at));
    const Graded graded = submission.grade("06-rotation");
    const std::string message = graded.message("EulerRodrigues.ImageOfAVector");
    EXPECT_EQ(message.find("open"), std::string::npos) << message;
    // Whoever is quick is not seen at the limit, and only meets it.
    if (graded.status("EulerRodrigues.ImageOfAVector") != "pass") {
        EXPECT_NE(message.find("started more than 64 processes"), std::string::npos) << message;
    }
}

TEST(OneErrorOneCharge, ATransposedRotationLosesIn06Only) {
    Submission submission;
    submission.replace(kRotation, "    return R;\n    // END TODO(rotation)",
                       "    return glm::transpose(R);\n    // END TODO(rotation)");
    EXPECT_EQ(submission.grade("06-rotation").losses(), Ids{"rotation"});
    const Graded camera = submission.grade("07-camera");
    EXPECT_EQ(camera.points(), 100.0) << camera.text;
    EXPECT_TRUE(camera.notes("nothing is charged twice"));
}

TEST(OneErrorOneCharge, ACompensatingCameraKeepsItsPointsIn07) {
    Submission submission;
    submission.replace(kRotation, "    return R;\n    // END TODO(rotation)",
                       "    return glm::transpose(R);\n    // END TODO(rotation)");
    submission.replace(kCamera, "rotation(degrees, up)", "rotation(-degrees, up)");
    submission.replace(kCamera, "rotation(-degrees, right)", "rotation(degrees, right)");
    EXPECT_EQ(submission.grade("06-rotation").losses(), Ids{"rotation"});
    EXPECT_EQ(submission.grade("07-camera").points(), 100.0);
}

TEST(OneErrorOneCharge, AnInheritedFileThatDoesNotCompileIsReplaced) {
    Submission submission;
    submission.write(kRotation, submission.read(kRotation) + "\nthis is no C++\n");
    EXPECT_EQ(submission.grade("06-rotation").document.at("status"), "build_error");
    const Graded camera = submission.grade("07-camera");
    EXPECT_EQ(camera.points(), 100.0);
    EXPECT_TRUE(camera.notes("the inherited file rotation.cpp does not compile"));
    EXPECT_EQ(camera.document.at("inherited").at("rotation.cpp"), "solutions");
}

TEST(OneErrorOneCharge, ARotationInsideTheCameraLinksAndGrades) {
    // As in code 7.2 of the notes: no header, and the function beside the camera's.
    Submission submission;
    std::string camera = submission.read(kCamera);
    const std::string include = "#include \"rotation.h\"  // your own, from 06-rotation\n";
    ASSERT_NE(camera.find(include), std::string::npos);
    camera.replace(
        camera.find(include), include.size(),
        "glm::mat3 rotation(const float degrees, const glm::vec3 axis) {\n"
        "    return glm::mat3(glm::rotate(glm::mat4(1.0f), glm::radians(degrees), axis));\n"
        "}\n");
    submission.write(kCamera, camera);
    lab::fs::remove_all(submission.folder() / "06-rotation");
    EXPECT_EQ(submission.grade("07-camera").points(), 100.0);
    EXPECT_EQ(submission.grade("08-perspective").points(), 100.0);
}

TEST(OneErrorOneCharge, AnEditOfAnIncludedSourceFileIsSeen) {
    // The compiled Camera.cpp in the cache must not outlive the rotation.cpp that it includes.
    Submission submission;
    submission.replace(kCamera, "#include \"rotation.h\"", "#include \"rotation.cpp\"");
    EXPECT_FALSE(submission.grade("07-camera").notes("nothing is charged twice"));
    submission.replace(kRotation, "    return R;\n    // END TODO(rotation)",
                       "    return glm::transpose(R);\n    // END TODO(rotation)");
    EXPECT_TRUE(submission.grade("07-camera").notes("nothing is charged twice"));
}

TEST(Limits, ALoopThatNeverEndsCostsItsOwnTaskOnly) {
    Submission submission;
    submission.solve(
        "06-rotation/rotation.cpp", "rotation",
        "    volatile int turns = 1;\n    while (turns) {}\n    return glm::mat3(1.0f);");
    const Graded graded = submission.grade("06-rotation");
    EXPECT_EQ(graded.losses(), std::vector<std::string>{"rotation"});
    EXPECT_EQ(graded.points(), 55.0);
    EXPECT_EQ(graded.status("turned"), "timeout");
}

}  // namespace
