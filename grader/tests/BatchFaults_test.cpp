// What may befall a batch: it is killed or stopped, the disk is full, the clock jumps, something
// hangs. Every time a clear error, nothing lost, and the same command goes on.

#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>

#include "BatchLab.h"

namespace {

using lab::BatchTest;
using lab::Graded;
using lab::kRotation;
using lab::Submission;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
namespace fs = lab::fs;

/// Command lines of all processes that have to do with a folder.
std::vector<std::string> processesAt(const fs::path& folder) {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        std::string line;
        try {
            line = lab::readFile(entry.path() / "cmdline");
        } catch (const std::exception&) {
            continue;  // no process, or it has ended meanwhile
        }
        if (line.find(folder.string()) != std::string::npos)
            found.push_back(line);
    }
    return found;
}

/// Runs a script of bash with these variables.
Graded script(const std::string& text, std::vector<std::string> variables, double seconds = 120) {
    std::vector<std::string> command = {"env"};
    command.insert(command.end(), variables.begin(), variables.end());
    command.insert(command.end(), {"bash", "-c", text});
    const auto result = lab::run(command, seconds);
    return {result.exitCode, result.output, nullptr};
}

class BatchFaults : public BatchTest {
protected:
    /// What a script needs to start a batch: "$GRADER" batch "$HOMES" … --out "$OUT".
    std::vector<std::string> names() const {
        return {std::string("GRADER=") + COURSE_GRADER, "HOMES=" + home().string(),
                "OUT=" + out().string()};
    }
};

TEST_F(BatchFaults, GoesOnWhereItWasKilled) {
    // Killed as soon as the first of four is remembered.
    lab::run({"bash", "-c",
              "\"$0\" batch \"$1\" --assignment 06-rotation --out \"$2\" --jobs 1 & "
              "until ls \"$2\"/students/*/key; do sleep 0.02; done; kill -9 $!",
              COURSE_GRADER, home().string(), out().string()},
             60);
    EXPECT_FALSE(fs::exists(out() / "results.json")) << "it was not killed in time";
    const Graded second = batch();
    EXPECT_EQ(second.exitCode, 0) << second.text;
    EXPECT_THAT(second.text, HasSubstr("4/4"));
    EXPECT_THAT(second.text, HasSubstr("(as before)")) << "the largest is begun first";
    EXPECT_EQ(student("honest").at("points"), 100.0);
    EXPECT_EQ(student("half").at("points"), 75.0);
}

TEST_F(BatchFaults, WhatVanishedIsNobodysFault) {
    // The first of four holds the batch for the second that its build hangs; by then the rest is
    // gone.
    Submission slow;
    slow.write(kRotation, std::string(100000, ' ') + "#include \"/dev/zero\"\nfor(;;);");
    put("a-slow", slow);
    lab::run({"bash", "-c",
              "\"$0\" batch \"$1\" --assignment 06-rotation --out \"$2\" --jobs 1 & "
              "until [ -e \"$2\"/students/a-slow ]; do sleep 0.01; done; rm -r \"$1\"/half; wait",
              COURSE_GRADER, home().string(), out().string()},
             120);
    EXPECT_EQ(student("half").at("status"), "grader_error");
    EXPECT_THAT(student("half").at("sentence").get<std::string>(), HasSubstr("and is gone"));
    EXPECT_EQ(student("honest").at("points"), 100.0) << "the others have their marks";
}

TEST_F(BatchFaults, OneFolderTakesOneBatchAtATime) {
    fs::create_directories(out());
    const auto locked =
        lab::run({"flock", (out() / "lock").string(), COURSE_GRADER, "batch", home().string(),
                  "--assignment", "06-rotation", "--out", out().string()},
                 60);
    EXPECT_EQ(locked.exitCode, 2);
    EXPECT_THAT(locked.output, HasSubstr("another batch is writing to"));
    EXPECT_FALSE(fs::exists(out() / "results.json"));
}

TEST_F(BatchFaults, AFullDiskIsSaidAndNothingIsLost) {
    fs::create_directories(out());
    if (!lab::run({"mount", "-t", "tmpfs", "-o", "size=300k", "none", out().string()}, 10)
             .succeeded())
        GTEST_SKIP() << "a small disk cannot be mounted here";
    const Graded full = batch();
    EXPECT_EQ(full.exitCode, 2) << full.text;
    EXPECT_THAT(full.text, HasSubstr("No space left on device"));
    lab::run({"mount", "-o", "remount,size=64m", out().string()}, 10);
    const Graded again = batch();
    EXPECT_EQ(again.exitCode, 0) << again.text;
    EXPECT_EQ(student("honest").at("points"), 100.0);
    EXPECT_EQ(student("half").at("points"), 75.0);
    lab::run({"umount", out().string()}, 10);
}

TEST_F(BatchFaults, AnOutputThatCannotBeWrittenIsNamed) {
    const Graded graded = lab::runGrader({"batch", home().string(), "--assignment", "06-rotation",
                                          "--out", (home() / "list.txt" / "out").string()});
    EXPECT_EQ(graded.exitCode, 2);
    EXPECT_THAT(graded.text, HasSubstr("list.txt"));
}

class Stopped : public BatchFaults, public testing::WithParamInterface<const char*> {};

TEST_P(Stopped, EndsCleanlyAndGoesOn) {
    const fs::path temporary = work_.path() / "temporary";
    fs::create_directories(temporary);
    auto variables = names();
    variables.push_back("TMPDIR=" + temporary.string());
    const Graded stopped =
        script(std::string("\"$GRADER\" batch \"$HOMES\" --assignment 06-rotation --out \"$OUT\" "
                           "--jobs 1 & until ls \"$OUT\"/students/*/key >/dev/null 2>&1; do "
                           "sleep 0.02; done; kill -") +
                   GetParam() + " $!; wait $!",
               variables);
    EXPECT_EQ(stopped.exitCode, 2) << stopped.text;
    EXPECT_THAT(stopped.text, HasSubstr("stopped: the same command goes on"));
    EXPECT_THAT(stopped.text, Not(HasSubstr("4/4")));
    EXPECT_TRUE(fs::exists(out() / "index.html")) << "what there is can be looked at";
    EXPECT_TRUE(fs::is_empty(temporary)) << "a work folder is left";
    EXPECT_THAT(processesAt(temporary), IsEmpty());
    const Graded rest = batch();
    EXPECT_EQ(rest.exitCode, 0) << rest.text;
    EXPECT_THAT(rest.text, HasSubstr("(as before)"));
    EXPECT_EQ(student("honest").at("points"), 100.0);
    EXPECT_EQ(student("half").at("points"), 75.0);
}
INSTANTIATE_TEST_SUITE_P(BatchFaults, Stopped, testing::Values("INT", "TERM"),
                         [](const auto& each) { return std::string(each.param); });

TEST_F(BatchFaults, AnOutputThatIsReadOnlyIsSaidAndKeepsWhatItHas) {
    ASSERT_EQ(batch().exitCode, 0);
    const std::string before = lab::readFile(out() / "results.csv");
    constexpr const char* kReadOnly =
        "mount --bind \"$OUT\" \"$OUT\" && mount -o remount,bind,ro \"$OUT\"";
    if (script(std::string("unshare -m bash -c '") + kReadOnly + "'", names()).exitCode != 0)
        GTEST_SKIP() << "no mount namespace can be made here, so nothing can be mounted read-only";
    const Graded refused =
        script(std::string("unshare -m bash -c '") + kReadOnly +
                   " && \"$GRADER\" batch \"$HOMES\" --assignment 06-rotation --out \"$OUT\"'",
               names());
    EXPECT_EQ(refused.exitCode, 2) << refused.text;
    EXPECT_THAT(refused.text, HasSubstr(out().string()));
    EXPECT_THAT(refused.text, HasSubstr("Read-only file system"));
    EXPECT_EQ(lab::readFile(out() / "results.csv"), before);
    EXPECT_THAT(batch().text, HasSubstr("half 75 of 100 (as before)"));
}

TEST_F(BatchFaults, AClockThatJumpsChangesNothing) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "a sanitizer's library wants to be loaded before any other";
#endif
    ASSERT_EQ(batch({"--seed", "7"}).exitCode, 0);
    const std::string calm = lab::readFile(out() / "results.csv");
    fs::remove_all(out());
    // Every look at the clock of the day is hours before or after the one before it.
    auto variables = names();
    variables.push_back(std::string("LD_PRELOAD=") + JUMPING_CLOCK);
    ASSERT_EQ(script("test $(($(date +%s) - $(env -u LD_PRELOAD date +%s))) -gt 3600", variables)
                  .exitCode,
              0)
        << "the clock does not jump";
    const std::string command =
        "\"$GRADER\" batch \"$HOMES\" --assignment 06-rotation --seed 7 --out \"$OUT\"";
    const Graded jumping = script(command, variables);
    EXPECT_EQ(jumping.exitCode, 0) << jumping.text;
    EXPECT_EQ(lab::readFile(out() / "results.csv"), calm);
    EXPECT_THAT(script(command, variables).text, HasSubstr("half 75 of 100 (as before)"))
        << "what is known stays known";
}

TEST_F(BatchFaults, WhatTakesLongerThanItCanIsTheGradersFault) {
    const fs::path temporary = work_.path() / "temporary";
    fs::create_directories(temporary);
    auto variables = names();
    variables.push_back("TMPDIR=" + temporary.string());
    const Graded cut = script(
        "\"$GRADER\" batch \"$HOMES\" --assignment 06-rotation --out \"$OUT\" --longest 0.05",
        variables);
    EXPECT_EQ(cut.exitCode, 2) << cut.text;
    EXPECT_EQ(student("honest").at("status"), "grader_error");
    EXPECT_THAT(student("honest").at("sentence").get<std::string>(), HasSubstr("took longer"));
    EXPECT_TRUE(fs::is_empty(temporary)) << "a work folder is left";
    EXPECT_THAT(processesAt(temporary), IsEmpty());
    const Graded again = batch();
    EXPECT_EQ(again.exitCode, 0) << again.text;
    EXPECT_THAT(again.text, Not(HasSubstr("honest 100 of 100 (as before)")));
    EXPECT_EQ(student("honest").at("points"), 100.0) << "it was never remembered as a mark";
}

TEST_F(BatchFaults, WhatHangsInTheGraderItselfHoldsUpNobody) {
    // The archive becomes a pipe that nobody writes to, once the batch has begun with the largest.
    Submission large;
    large.write(kRotation, large.read(kRotation) + "// " + std::string(100000, '-') + "\n");
    put("a-large", large);
    const Graded hung = script(
        "\"$GRADER\" batch \"$HOMES\" --assignment 06-rotation --out \"$OUT\" --jobs 1 "
        "--longest 1 & until [ -e \"$OUT\"/students/a-large ]; do sleep 0.01; done; "
        "mkfifo \"$HOMES\"/pipe; mv \"$HOMES\"/pipe \"$HOMES\"/text.zip; wait $!",
        names());
    EXPECT_EQ(hung.exitCode, 2) << hung.text;
    EXPECT_EQ(student("text").at("status"), "grader_error") << hung.text;
    EXPECT_THAT(student("text").at("sentence").get<std::string>(), HasSubstr("given up"));
    EXPECT_EQ(students().size(), 5u) << "the others have had their turn";
}

}  // namespace
