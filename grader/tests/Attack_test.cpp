// Attacks that take two submissions, or another way to run one, than a case of hostile/ has.

#include <gmock/gmock.h>
#include <unistd.h>

#include <functional>

#include "BatchLab.h"

namespace {

using lab::BatchTest;
using lab::Graded;
using lab::Json;
using lab::kRotation;
using lab::Submission;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
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

/// A file for 06-rotation, all of whose functions throw what `look` returns, a text.
std::string rotationThatTells(const std::string& look) {
    const std::string tell = " { throw std::runtime_error(look()); }\n";
    return "#include \"rotation.h\"\n#include <chrono>\n#include <filesystem>\n#include <fstream>\n"
           "#include <iterator>\n#include <stdexcept>\n#include <string>\n"
           "namespace fs = std::filesystem;\n"
           "static std::string textOf(const fs::path& file) {\n"
           "    std::ifstream in(file);\n"
           "    return std::string(std::istreambuf_iterator<char>(in), {});\n"
           "}\n"
           "static std::string look() {\n" +
           look + "}\nglm::mat3 crossMatrix(const glm::vec3)" + tell +
           "glm::mat3 rotation(const float, const glm::vec3)" + tell +
           "glm::mat3 eulerRodrigues(const float, const glm::vec3)" + tell;
}

/// Looks for pictures and for the text of a hidden test wherever a submission could come.
const std::string kLooksForSecrets = R"(
    const std::string hidden = std::string("DrawnAxes") + "OfAnyLength";
    const auto flags = fs::directory_options::skip_permission_denied;
    int files = 0, found = 0;
    std::string names;
    for (const auto& top : fs::directory_iterator("/")) {
        const std::string name = top.path().filename();
        if (name == "proc" || name == "sys" || name == "usr" || top.is_symlink())
            continue;
        std::error_code none;
        for (fs::recursive_directory_iterator each(top, flags, none), end; !none && each != end;
             each.increment(none)) {
            if (!each->is_regular_file(none) || each->file_size(none) > (50u << 20))
                continue;
            const std::string text = textOf(each->path());
            ++files;
            if (text.rfind("\x89PNG", 0) != 0 && text.find(hidden) == std::string::npos)
                continue;
            ++found;
            names += " " + each->path().string();
        }
    }
    return "looked into " + std::to_string(files) + " files, found " + std::to_string(found) + names;
)";

/// For a while, looks into the folders of all other jobs for one of these files that has a word in
/// it; `files` is a list as C++ writes it.
std::string looksAtNeighbours(const std::string& files, const std::string& word) {
    return "const fs::path own = fs::current_path().parent_path();\n"
           "const char* const files[] = {" +
           files + "};\nconst std::string word = \"" + word + "\";\n" + R"(
    using Clock = std::chrono::steady_clock;
    for (const auto end = Clock::now() + std::chrono::milliseconds(500); Clock::now() < end;) {
        std::error_code none;
        for (fs::directory_iterator job(own.parent_path(), none), last; !none && job != last;
             job.increment(none)) {
            if (job->path() == own || job->path().filename().string().rfind("course-", 0) != 0)
                continue;
            for (const char* each : files)
                if (textOf(job->path() / each).find(word) != std::string::npos)
                    return std::string("found ") + each;
        }
    }
    return "found nothing";
)";
}

/// All that a submission was told of its checks.
std::string messagesIn(const Json& document) {
    std::string all;
    for (const Json& task : document.at("tasks"))
        for (const Json& check : task.at("checks"))
            all += check.at("message").get<std::string>() + "\n";
    return all;
}

TEST_F(AttackOnABatch, NoReferenceAndNoHiddenTestIsFound) {
    // The largest is graded first: when the attack comes, the references of the secret seed and an
    // instructor's report with them lie on the disk.
    lab::writeFile(home() / "honest" / kRotation,
                   std::string(30000, '\n') + lab::readFile(home() / "honest" / kRotation));
    lab::writeFile(home() / "attacker" / kRotation, rotationThatTells(kLooksForSecrets));
    const Graded graded = batch({"--jobs", "1"});
    ASSERT_EQ(graded.exitCode, 0) << graded.text;
    const fs::path secret = "report/06-rotation/seeded-turn.reference.png";
    ASSERT_TRUE(fs::exists(out() / "instructor/honest" / secret));
    for (const char* each : {"honest", "half", "attacker"})
        EXPECT_FALSE(fs::exists(out() / "students" / each / secret)) << each;
    const Json result = lab::parseJsonFile((out() / "students/attacker/result.json").string());
    if (result.at("environment").at("sandbox") != "bubblewrap")
        GTEST_SKIP() << "the checkout is everybody's to read, and no sandbox hides it";
    EXPECT_EQ(result.at("points"), 0.0);
    const std::string told = messagesIn(result);
    EXPECT_THAT(told, ContainsRegex("looked into [1-9][0-9]* files, found 0\n"));
    EXPECT_THAT(told, Not(ContainsRegex("found [1-9]")));
}

/// The same on a machine without a sandbox, where all that keeps neighbours apart is who they are.
class AttackOnNeighbours : public AttackOnABatch {
protected:
    void SetUp() override {
        if (geteuid() != 0)
            GTEST_SKIP() << "as an ordinary user all submissions are the same user's";
        fs::remove_all(home());
    }
    /// Six neighbours and, under number 0, an attacker, who is graded first because there is the
    /// most to read. `name` is the file of a student by number.
    void makeClass(const std::function<std::string(int)>& name, const std::string& look) const {
        const std::string honest =
            "// a neighbour's own work\n" + lab::readFile(lab::root() / "solutions" / kRotation);
        for (int i = 1; i <= 6; ++i)
            lab::writeFile(home() / name(i), honest);
        lab::writeFile(home() / name(0), rotationThatTells(look) + std::string(30000, '\n'));
    }
    void expectNothingFound(const std::string& attacker) const {
        const Graded graded = batch({"--jobs", "3", "--no-sandbox"});
        ASSERT_EQ(graded.exitCode, 0) << graded.text;
        ASSERT_EQ(students().size(), 7u);
        for (const Json& each : students())
            EXPECT_EQ(each.at("points"), each.at("submission") == attacker ? 0.0 : 100.0) << each;
        const std::string told = messagesIn(
            lab::parseJsonFile((out() / "students" / attacker / "result.json").string()));
        EXPECT_THAT(told, HasSubstr("found nothing"));
        EXPECT_THAT(told, Not(ContainsRegex("found [a-z]+[./]")));
    }
};

TEST_F(AttackOnNeighbours, TheirAnswersToTheSecretSeedAreClosed) {
    makeClass([](int i) { return fmt::format("student{}/{}", i, kRotation); },
              looksAtNeighbours(R"("checks.json", "judge/checks.json")", "evidence"));
    expectNothingFound("student0");
}

TEST_F(AttackOnNeighbours, TheirLooseFilesAreClosed) {
    // As Canvas exports them.
    makeClass(
        [](int i) { return fmt::format("student{0}_100{0}_500{0}_rotation.cpp", i); },
        looksAtNeighbours(R"("submission/rotation.cpp", "submission/06-rotation/rotation.cpp")",
                          "a neighbour's own work"));
    expectNothingFound("student0_1000");
}

}  // namespace
