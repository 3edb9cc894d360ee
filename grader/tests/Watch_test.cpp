// ./grade --watch as students run it: in a terminal, beside an editor that saves in its own way.

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "Lab.h"
#include "Regions.h"
#include "testing/PseudoTerminal.h"

namespace {

using lab::fs::path;
using testing::HasSubstr;
using testing::Not;
using testing_help::PseudoTerminal;

const std::string kRotation = "06-rotation/rotation.cpp";
const std::string kCamera = "07-camera/Camera.cpp";
const std::string kWaiting = "q quit";  // the end of the line with the keys

class Watch : public testing::Test {
protected:
    Watch() {
        lab::fs::create_directories(temporary());
        setenv("TMPDIR", temporary().c_str(), 1);
    }
    ~Watch() override { unsetenv("TMPDIR"); }

    path temporary() const { return work_.path() / "tmp"; }

    std::vector<std::string> command(const std::string& assignment,
                                     const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all = {COURSE_GRADER, "--watch", assignment, "--submission",
                                        submission_.folder().string()};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    /// The same below a shell with job control.
    std::vector<std::string> inAShell(const std::string& script) const {
        std::vector<std::string> all = {"bash", "-c", "set -m; " + script, "bash"};
        const auto watch = command("06-rotation");
        all.insert(all.end(), watch.begin(), watch.end());
        return all;
    }

    /// The text of a solved file with another body in one of its regions.
    std::string with(const std::string& name, const std::string& region,
                     const std::string& body) const {
        return lab::withRegion(solved(name), region, body).value();
    }
    std::string solved(const std::string& name) const {
        return lab::readFile(lab::root() / "solutions" / name);
    }

    /// As cp and some editors do: the same file is emptied and written.
    void overwrite(const std::string& name, const std::string& text) const {
        std::ofstream(submission_.file(name), std::ios::trunc) << text;
    }
    /// As vim and gedit do: a new file gets the name.
    void replace(const std::string& name, const std::string& text) const {
        const path fresh = submission_.file(name).string() + "~";
        std::ofstream(fresh, std::ios::trunc) << text;
        lab::fs::rename(fresh, submission_.file(name));
    }
    static void wait(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

    lab::WorkFolder work_;
    lab::Submission submission_;
};

TEST_F(Watch, EveryWayToSaveIsGradedAndComparedWithTheLast) {
    PseudoTerminal terminal(command("06-rotation"));
    terminal.waitFor("100 / 100");
    terminal.waitFor(kWaiting);

    overwrite(kRotation, with(kRotation, "cross-matrix", "    return glm::mat3(1.0f);\n"));
    const std::string lost = terminal.waitFor(kWaiting);
    EXPECT_THAT(lost, HasSubstr("no longer: "));
    EXPECT_THAT(lost, HasSubstr("✗ cross-matrix: "));
    EXPECT_THAT(lost, Not(HasSubstr("100 / 100")));

    replace(kRotation, solved(kRotation));
    const std::string won = terminal.waitFor(kWaiting);
    EXPECT_THAT(won, HasSubstr("100 / 100"));
    EXPECT_THAT(won, HasSubstr("now "));
    EXPECT_THAT(won, HasSubstr("Everything is done"));

    // The same text again, and files that are nobody's, grade nothing.
    replace(kRotation, solved(kRotation));
    overwrite("06-rotation/.rotation.cpp.swp", "something else");
    EXPECT_EQ(terminal.untilSilent(1.0), "");

    // Gone for a moment, then empty for a moment: only what comes then is graded.
    lab::fs::remove(submission_.file(kRotation));
    overwrite(kRotation, "");
    overwrite(kRotation, with(kRotation, "rotation", "    return glm::mat3(1.0f);\n"));
    const std::string again = terminal.waitFor(kWaiting);
    EXPECT_THAT(again, HasSubstr("✗ rotation: "));
    EXPECT_EQ(again.find("grading"), again.rfind("grading")) << again;

    // Gone for good: the starter takes its place, and the reader is told that something was lost.
    lab::fs::remove(submission_.file(kRotation));
    EXPECT_THAT(terminal.waitFor(kWaiting), HasSubstr("0 / 100"));
    overwrite(kRotation, solved(kRotation));
    EXPECT_THAT(terminal.waitFor(kWaiting), HasSubstr("100 / 100"));
}

TEST_F(Watch, ABuildErrorKeepsWhatIsComparedWith) {
    PseudoTerminal terminal(command("06-rotation"));
    terminal.waitFor(kWaiting);
    overwrite(kRotation, with(kRotation, "rotation", "    return degres;\n"));
    const std::string broken = terminal.waitFor(kWaiting);
    EXPECT_THAT(broken, HasSubstr("rotation.cpp:"));
    EXPECT_THAT(broken, HasSubstr("'degres' was not declared"));
    EXPECT_THAT(broken, HasSubstr("it stood at 100 / 100"));
    EXPECT_THAT(broken, Not(HasSubstr("no longer")));
    terminal.type("h");
    EXPECT_THAT(terminal.waitFor("hint: "), HasSubstr("degres"));
    terminal.waitFor(kWaiting);
    terminal.type("n");
    const std::string next = terminal.waitFor(kWaiting);
    EXPECT_THAT(next, HasSubstr("'degres' was not declared"));
    EXPECT_THAT(next, Not(HasSubstr("cross-matrix"))) << "which stands at full points";
    overwrite(kRotation, solved(kRotation) + "// mended\n");
    const std::string mended = terminal.waitFor(kWaiting);
    EXPECT_THAT(mended, HasSubstr("No points earned or lost."));
    terminal.type("q");
    EXPECT_EQ(terminal.waitForEnd(), 0);
}

TEST_F(Watch, KeysTellTheHintAndTheTasksAndLeave) {
    replace(kRotation, with(kRotation, "cross-matrix", "    return glm::mat3(1.0f);\n"));
    PseudoTerminal terminal(command("06-rotation"));
    terminal.waitFor(kWaiting);
    EXPECT_FALSE(terminal.isAsBefore()) << "keys are read one by one";
    terminal.type("h");
    terminal.waitFor("hint: ");
    terminal.waitFor(kWaiting);
    terminal.type("n");
    terminal.waitFor("cross-matrix");
    terminal.waitFor("TODO(cross-matrix)");
    terminal.waitFor(kWaiting);
    terminal.type("r");
    terminal.waitFor("06-rotation  Rotation");
    terminal.waitFor(kWaiting);
    terminal.type("\033[A?");  // an arrow, and a key that means nothing
    EXPECT_EQ(terminal.untilSilent(0.3), "");
    terminal.type("q");
    EXPECT_EQ(terminal.waitForEnd(), 1);
    EXPECT_TRUE(terminal.isAsBefore());
}

TEST_F(Watch, TheLastOfManySavesGetsAVerdict) {
    PseudoTerminal terminal(command("06-rotation"));
    terminal.waitFor(kWaiting);
    const std::string wrong = with(kRotation, "rotation", "    return glm::mat3(1.0f);\n");
    for (int i = 0; i < 30; ++i) {
        const std::string text = wrong + "// save " + std::to_string(i) + "\n";
        if (i % 2 == 0)
            replace(kRotation, text);
        else
            overwrite(kRotation, text);
        wait(100);
    }
    overwrite(kRotation, with(kRotation, "rotation", "    return lastOfAll;\n"));
    terminal.waitFor("lastOfAll");
    terminal.waitFor(kWaiting);
    EXPECT_EQ(terminal.untilSilent(1.0), "");
}

TEST_F(Watch, WhatAGradingReadHalfWrittenIsGradedAgain) {
    PseudoTerminal terminal(command("06-rotation"));
    terminal.waitFor(kWaiting);
    // Saved twice, as an editor does that formats: the second time the file is empty for a moment,
    // and the grading of the first save begins within these milliseconds.
    for (int ms = 14; ms < 29; ++ms) {
        const std::string text = solved(kRotation) + "// " + std::to_string(ms) + "\n";
        replace(kRotation, text);
        wait(ms);
        overwrite(kRotation, "");
        wait(4);
        overwrite(kRotation, text);
        std::string verdicts = terminal.waitFor(kWaiting);
        verdicts += terminal.untilSilent(0.7);
        EXPECT_GT(verdicts.rfind("100 / 100") + 1, verdicts.rfind(" 0 / 100") + 1) << verdicts;
    }
}

TEST_F(Watch, AnEndlessLoopIsAbandonedWhenItIsMended) {
    PseudoTerminal terminal(command("06-rotation"));
    terminal.waitFor(kWaiting);
    overwrite(kRotation, with(kRotation, "rotation", "    for (volatile int i = 0;; i = 1) {}\n"));
    wait(1500);  // long enough to compile and to run into it
    overwrite(kRotation, with(kRotation, "rotation", "    return glm::mat3(1.0f);\n"));
    const std::string verdict = terminal.waitFor(kWaiting);
    EXPECT_THAT(verdict, HasSubstr("✗ rotation: "));
    EXPECT_THAT(verdict, Not(HasSubstr("did not finish"))) << "the verdict of the endless loop";
}

TEST_F(Watch, ShadersAreWatchedToo) {
    const std::string shader = "10-lighting/shaders/lighting.frag";
    PseudoTerminal terminal(command("10-lighting"));
    terminal.waitFor(kWaiting);
    overwrite(shader, with(shader, "emission", "oops\n"));
    const std::string broken = terminal.waitFor(kWaiting);
    EXPECT_THAT(broken, HasSubstr("shaders/lighting.frag does not compile"));
    EXPECT_THAT(broken, HasSubstr("shaders/lighting.frag:"));
    EXPECT_THAT(broken, Not(HasSubstr("no longer")));
    replace(shader, with(shader, "emission",
                         lab::readFile(lab::root() /
                                       "solutions/10-lighting/mistakes/emission-missing.frag")));
    const std::string without = terminal.waitFor(kWaiting);
    EXPECT_THAT(without, HasSubstr("✗ emission: "));
    EXPECT_THAT(without, HasSubstr("no longer: "));
}

TEST_F(Watch, AnInheritedFileGradesEveryAssignmentThatUsesIt) {
    PseudoTerminal terminal([&] {
        auto all = command("06-rotation");
        all.insert(all.begin() + 2, {"07-camera", "08-perspective"});
        return all;
    }());
    terminal.waitFor(kWaiting);
    const auto perspective = [&](const std::string& body) {
        overwrite(kCamera, with(kCamera, "perspective", body));
        terminal.waitFor("08-perspective  ");
        return terminal.waitFor(kWaiting);
    };
    EXPECT_THAT(perspective("    proj = glm::mat4(1.0f);\n"), HasSubstr("✗ perspective: "));
    EXPECT_THAT(perspective("    proj = glm::mat4(2.0f);\n"),
                HasSubstr("No points earned or lost."));
}

TEST_F(Watch, ATaskInAFileOfAnEarlierAssignmentHasItsVerdictsAndItsPlace) {
    const std::string wrong[] = {with(kCamera, "perspective", "    proj = glm::mat4(1.0f);\n"),
                                 with(kCamera, "perspective", "    proj = glm::mat4(2.0f);\n")};
    const auto line =
        1 + std::count(wrong[0].begin(),
                       wrong[0].begin() + long(wrong[0].find("// BEGIN TODO(perspective)")), '\n');
    const std::string place = "Camera.cpp:" + std::to_string(line);
    replace(kCamera, wrong[0]);
    PseudoTerminal terminal(command("08-perspective"));
    EXPECT_THAT(terminal.waitFor(kWaiting),
                HasSubstr("Watching 08-perspective: projection.cpp, Camera.cpp"));
    const auto save = [&](const std::string& name, const std::string& text) {
        replace(name, text);
        const std::string verdict = terminal.waitFor(kWaiting);
        EXPECT_THAT(verdict, HasSubstr("No points earned or lost.")) << name;
        EXPECT_THAT(verdict, HasSubstr("✗ perspective: ")) << name;
        terminal.type("n");
        return terminal.waitFor(kWaiting);
    };
    EXPECT_THAT(save(kCamera, wrong[1]), HasSubstr("07-camera/" + place));
    // Carried forward, the copies count.
    save("08-perspective/Camera.h", solved("07-camera/Camera.h"));
    EXPECT_THAT(save("08-perspective/Camera.cpp", wrong[0]), HasSubstr("08-perspective/" + place));
    save("08-perspective/Camera.cpp", wrong[1]);
}

TEST_F(Watch, CtrlCAmidAGradingLeavesNothing) {
    PseudoTerminal terminal(command("06-rotation"));
    terminal.waitFor(kWaiting);
    overwrite(kRotation, with(kRotation, "rotation", "    for (volatile int i = 0;; i = 1) {}\n"));
    terminal.waitFor("grading 06-rotation");
    wait(1200);
    const pid_t watcher = terminal.pid();
    EXPECT_FALSE(lab::fs::is_empty(temporary()));
    terminal.type("\003");
    EXPECT_EQ(terminal.waitForEnd(), 0) << "the last verdict was full marks";
    EXPECT_TRUE(terminal.isAsBefore());
    EXPECT_TRUE(lab::fs::is_empty(temporary()));
    // Whatever it had started saw its own place for files, and nobody who does is left.
    for (const auto& entry : lab::fs::directory_iterator("/proc")) {
        std::ifstream environment(entry.path() / "environ");
        const std::string text(std::istreambuf_iterator<char>(environment), {});
        const bool isThis = entry.path().filename() == std::to_string(getpid());
        EXPECT_TRUE(isThis || text.find(temporary().string()) == std::string::npos) << entry.path();
    }
    EXPECT_NE(kill(watcher, 0), 0);
}

TEST_F(Watch, StoppedItGivesTheTerminalBackAndGoesOnLater) {
    PseudoTerminal terminal(inAShell("\"$@\"; echo stopped; read; fg"));
    terminal.waitFor(kWaiting);
    terminal.type("\032");  // Ctrl-Z
    terminal.waitFor("stopped");
    EXPECT_TRUE(terminal.isAsBefore());
    terminal.type("\n");
    terminal.waitFor(kWaiting);
    EXPECT_FALSE(terminal.isAsBefore());
    terminal.type("q");
    EXPECT_EQ(terminal.waitForEnd(), 0);
    EXPECT_TRUE(terminal.isAsBefore());
}

TEST_F(Watch, OutOfTheBackgroundItReadsKeysAgain) {
    PseudoTerminal terminal(inAShell("\"$@\"; echo stopped; read; bg; read; fg"));
    terminal.waitFor(kWaiting);
    terminal.type("\032");
    terminal.waitFor("stopped");
    terminal.type("\n");
    terminal.waitFor(kWaiting);
    EXPECT_TRUE(terminal.isAsBefore()) << "the terminal is the shell's";
    terminal.type("\n");
    for (int i = 0; i < 1000 && terminal.isAsBefore(); ++i)
        wait(10);
    EXPECT_FALSE(terminal.isAsBefore());
    terminal.type("q");
    EXPECT_EQ(terminal.waitForEnd(), 0);
}

TEST_F(Watch, WhereNobodyCouldLetItGoOnItIsNotStopped) {
    PseudoTerminal terminal(command("06-rotation"));  // no shell above it
    terminal.waitFor(kWaiting);
    terminal.type("\032");
    terminal.waitFor(kWaiting);
    terminal.type("q");
    EXPECT_EQ(terminal.waitForEnd(), 0);
}

TEST_F(Watch, InAPipeThereAreLinesAndNoKeys) {
    std::string line = "exec \"$@\" | cat";
    std::vector<std::string> all = {"sh", "-c", line, "sh"};
    const auto watch = command("06-rotation");
    all.insert(all.end(), watch.begin(), watch.end());
    PseudoTerminal terminal(all);
    const std::string first = terminal.waitFor("✓ cross-matrix");
    EXPECT_THAT(first, HasSubstr("Ctrl-C ends this"));
    EXPECT_TRUE(terminal.isAsBefore());
    terminal.untilSilent(0.5);
    overwrite(kRotation, with(kRotation, "rotation", "    return glm::mat3(1.0f);\n"));
    const std::string verdict = terminal.waitFor("✗ rotation: ");
    EXPECT_THAT(verdict, HasSubstr("no longer: "));
    EXPECT_THAT(verdict, Not(HasSubstr("\033")));
    EXPECT_THAT(terminal.untilSilent(0.5), Not(HasSubstr("quit")));
    terminal.type("\003");
    terminal.waitForEnd();
}

TEST_F(Watch, ThePageHasANewVersionAfterEachVerdict) {
    const path page = work_.path() / "page";
    PseudoTerminal terminal(command("06-rotation", {"--report", page.string()}));
    terminal.waitFor("Report: ");
    terminal.waitFor(kWaiting);
    const std::string first = lab::readFile(page / "version.svg");
    EXPECT_THAT(lab::readFile(page / "index.html"), HasSubstr("data-version=\""));
    overwrite(kRotation, with(kRotation, "rotation", "    return glm::mat3(1.0f);\n"));
    terminal.waitFor(kWaiting);
    EXPECT_NE(lab::readFile(page / "version.svg"), first);
    EXPECT_THAT(lab::readFile(page / "index.html"), HasSubstr("Your picture"));
    terminal.type("q");
    terminal.waitForEnd();
    EXPECT_FALSE(lab::fs::exists(page / "version.svg")) << "nobody writes the page any more";
}

TEST_F(Watch, WhatCannotBeWatchedIsRefused) {
    for (const std::vector<std::string>& more :
         std::vector<std::vector<std::string>>{{"--json", "-"}, {"--seed", "2"}, {"--images"}}) {
        auto all = command("06-rotation", more);
        all.erase(all.begin());
        const lab::Graded graded = lab::runGrader(all);
        EXPECT_EQ(graded.exitCode, 2) << more[0];
        EXPECT_THAT(graded.text, HasSubstr("--watch"));
    }
    const lab::Graded unknown = lab::runGrader({"--watch", "07-kamera"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.text, HasSubstr("07-kamera"));
    const path archive = work_.path() / "a.tar";
    lab::run({"tar", "-C", submission_.folder().string(), "-cf", archive.string(),
              "06-rotation/rotation.cpp"},
             20.0);
    const lab::Graded packed =
        lab::runGrader({"--watch", "06-rotation", "--submission", archive.string()});
    EXPECT_EQ(packed.exitCode, 2);
    EXPECT_THAT(packed.text, HasSubstr("unpack it"));
}

}  // namespace
