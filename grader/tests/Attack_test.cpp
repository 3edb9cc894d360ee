// Attacks that take two submissions, or another way to run one, than a case of hostile/ has.

#include <unistd.h>

#include "BatchLab.h"

namespace {

using lab::BatchTest;
using lab::Graded;
using lab::kRotation;
using lab::Submission;
namespace fs = lab::fs;

/// A header whose uniforms are set only where the shader, which it takes into its own object, says
/// so. With the words hidden from who looks for them.
Graded gradedWithShaderInItsObject(const std::string& word) {
    const std::string header = "04-mandelbrot/MandelbrotShader.h";
    Submission submission;
    submission.replace(
        header, "#include \"Shader.h\"\n",
        "#include \"Shader.h\"\n#include <string>\n"
        "asm(\".pushsection .rodata\\ntaken:\\n.incb\" \"in "
        "\\\"shaders/mandelbrot.frag\\\"\\n.byte 0\\n.popsection\");\n"
        "extern \"C\" __attribute__((visibility(\"hidden\"))) const char taken[];\n");
    submission.replace(header, "glUniform1f(zoom_loc, zoom);",
                       "if (std::string(taken).find(\"GOOD\") != std::string::npos)\n"
                       "glUniform1f(zoom_loc, zoom);");
    submission.write(
        "04-mandelbrot/shaders/mandelbrot.frag",
        submission.read("04-mandelbrot/shaders/mandelbrot.frag") + "// " + word + "\n");
    return submission.grade("04-mandelbrot");
}

TEST(Attack, AnObjectDependsOnNothingThatItsKeyLeavesOut) {
    const double first = gradedWithShaderInItsObject("GOOD").points();
    const double second = gradedWithShaderInItsObject("BAD").points();
    EXPECT_EQ(first, second) << "what the first one made was taken for the second one's";
    EXPECT_LT(second, 100.0);
}

TEST(Attack, WithoutNamespacesItsNeighbourProcessIsNotTheMachine) {
    if (geteuid() != 0)
        GTEST_SKIP() << "as an ordinary user it would kill whatever that user runs";
    Submission submission;
    submission.write(kRotation, submission.read(kRotation) +
                                    "#include <signal.h>\n"
                                    "static const bool all = (kill(-1, SIGKILL), true);\n");
    const Graded graded = submission.grade("06-rotation", {"--no-sandbox"});
    EXPECT_EQ(graded.exitCode, 1) << graded.text;
    EXPECT_EQ(graded.document.at("status"), "graded");
    EXPECT_EQ(graded.points(), 0.0);
}

TEST(Attack, WithoutASandboxNothingStaysInTheTemporaryFolders) {
    if (geteuid() != 0)
        GTEST_SKIP() << "as an ordinary user its files are that user's own";
    const std::string left = "/var/tmp/left-by-a-submission";
    Submission submission;
    submission.write(kRotation, submission.read(kRotation) +
                                    "#include <cstdio>\n"
                                    "static const auto file = std::fopen(\"" +
                                    left + "\", \"w\");\n");
    const Graded graded = submission.grade("06-rotation", {"--no-sandbox"});
    EXPECT_EQ(graded.points(), 100.0) << graded.text;
    EXPECT_FALSE(fs::exists(left));
}

class AttackOnABatch : public BatchTest {};

TEST_F(AttackOnABatch, FoldersThatCannotBeLookedAtStopNobody) {
    for (const char* each : {"link/06-rotation", "git/.git", "refs/.git/refs/heads"})
        fs::create_directories((home() / each).parent_path());
    fs::create_symlink("06-rotation", home() / "link/06-rotation");
    fs::create_directories(home() / "link/07-camera");
    fs::create_symlink(".git", home() / "git/.git");
    lab::writeFile(home() / "refs/.git/HEAD", "ref: refs/heads/main\n");
    fs::create_directories(home() / "refs/.git/objects");
    fs::create_directories(home() / "refs/.git/refs/heads");
    fs::create_symlink("/dev/zero", home() / "refs/.git/refs/heads/main");
    const Graded graded = batch();
    EXPECT_EQ(graded.exitCode, 0) << graded.text;
    EXPECT_EQ(student("honest").at("points"), 100.0);
    for (const char* each : {"link", "git", "refs"})
        EXPECT_NE(student(each).at("status"), "grader_error") << each;
}

TEST_F(AttackOnABatch, NamesBehindALinkAreNotTold) {
    fs::create_directories(home() / "link/07-camera");
    fs::create_symlink("/etc", home() / "link/06-rotation");
    batch();
    const auto result = lab::parseJsonFile((out() / "students/link/result.json").string());
    EXPECT_TRUE(result.at("ignored_files").empty()) << result.dump(2);
}

TEST_F(AttackOnABatch, WhatIsKeptForReplayIsWhatWasTaken) {
    fs::create_directories(home() / "link");
    const fs::path mine = work_.path() / "elsewhere";
    fs::create_directories(mine);
    fs::copy(lab::root() / "solutions" / kRotation, mine / "rotation.cpp");
    fs::create_directories(home() / "link/07-camera");
    fs::create_symlink(mine, home() / "link/06-rotation");
    batch();
    EXPECT_EQ(student("link").at("points"), 0.0);
    EXPECT_FALSE(fs::exists(out() / "instructor/link/submission" / kRotation));
}

}  // namespace
