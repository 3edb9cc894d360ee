#include <gmock/gmock.h>

#include <fmt/format.h>

#include <algorithm>

#include "Lab.h"
#include "Regions.h"

/// Pull requests against a bare repository, graded by the very script that GitHub's action runs, in
/// a checkout of the base, with GitHub's environment files.
namespace {

using namespace grader;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kRotation = "assignments/06-rotation/rotation.cpp";
constexpr const char* kCamera = "assignments/07-camera/Camera.cpp";

struct Answer {
    int exitCode = -1;
    std::string log, summary, outputs;
    fs::path report;
};

class PullRequestTest : public testing::Test {
protected:
    PullRequestTest() {
        sh("git init -q --bare -b main hub.git && git clone -q hub.git student 2> /dev/null");
        fs::create_directories(student() / "assignments");
        for (const char* id : {"06-rotation", "07-camera"})
            fs::copy(lab::root() / "assignments" / id, student() / "assignments" / id,
                     fs::copy_options::recursive);
        write("grader/README", "the grader");
        commit("the course", "HEAD:main");
        sh("git clone -q hub.git base");
        eventsBase_ = commitOf("base", "HEAD");
        sh("git -C student checkout -q -b work");
    }

    fs::path student() const { return work_.path() / "student"; }
    static std::string solved(const std::string& path) {
        return readFile(lab::root() / "solutions" /
                        path.substr(std::string("assignments/").size()));
    }
    void write(const std::string& path, const std::string& content) {
        fs::create_directories((student() / path).parent_path());
        writeFile(student() / path, content);
    }
    /// Runs a line of shell in the test's folder.
    void sh(const std::string& line) {
        const ProcessResult ran =
            run({"env", "GIT_CONFIG_GLOBAL=/dev/null", "GIT_AUTHOR_NAME=A student",
                 "GIT_AUTHOR_EMAIL=student@example.org", "GIT_COMMITTER_NAME=A student",
                 "GIT_COMMITTER_EMAIL=student@example.org", "sh", "-c",
                 "cd '" + work_.path().string() + "' && " + line},
                60);
        ASSERT_TRUE(ran.succeeded()) << line << "\n" << ran.output;
    }
    /// Commits all that is there and pushes it to a name in the bare repository.
    void commit(const std::string& message, const std::string& to) {
        sh("cd student && git add -A && git commit -q --allow-empty -m '" + message +
           "' && git push -q origin " + to);
    }
    std::string commitOf(const std::string& folder, const std::string& name) {
        return run({"git", "-C", (work_.path() / folder).string(), "rev-parse", name}, 10)
            .output.substr(0, 40);
    }
    /// Opens pull request 7 with what the student's folder has, and grades it as GitHub would.
    Answer grade(const std::string& environment = "") {
        commit("my work", "+HEAD:refs/pull/7/head");
        return graded(commitOf("student", "HEAD"), environment);
    }
    Answer graded(const std::string& head, const std::string& environment = "") {
        const fs::path owned = work_.path() / "owned";
        const std::string attack = "touch " + owned.string();
        const Json event = {{"action", "synchronize"},
                            {"pull_request",
                             {{"number", 7},
                              {"title", "`" + attack + "` $(" + attack + ")"},
                              {"base", {{"sha", eventsBase_}}},
                              {"head", {{"sha", head}, {"ref", "$(" + attack + ")"}}}}}};
        const fs::path folder = work_.path();
        writeFile(folder / "event.json", event.dump());
        const std::string line = fmt::format(
            "cd '{0}/base' && env -i PATH=\"$PATH\" HOME='{0}' CI=true GITHUB_ACTIONS=true "
            "GITHUB_EVENT_PATH='{0}/event.json' GITHUB_STEP_SUMMARY='{0}/summary' "
            "GITHUB_OUTPUT='{0}/outputs' REPORT='{0}/report' {1} "
            "'{2}/.github/actions/grade/grade.sh' '{3}'",
            folder.string(), environment, lab::root().string(), COURSE_GRADER);
        const ProcessResult ran = run({"sh", "-c", line}, 120);
        EXPECT_FALSE(fs::exists(owned)) << "a text of the student's was run";
        const auto text = [&](const char* name) {
            return fs::exists(folder / name) ? readFile(folder / name) : "";
        };
        return {ran.exitCode, ran.output, text("summary"), text("outputs"), folder / "report"};
    }

    WorkFolder work_;
    std::string eventsBase_;  ///< which commit of the base the event names
};

TEST_F(PullRequestTest, SolvedPassesAndTheHeadIsNeverCheckedOut) {
    write(kRotation, solved(kRotation));
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
    EXPECT_THAT(answer.summary, HasSubstr("## 06-rotation Rotation: 100 / 100"));
    EXPECT_THAT(answer.summary, Not(HasSubstr("07-camera")));
    EXPECT_EQ(answer.outputs, "points=100\nmax-points=100\npassed=true\n");
    EXPECT_TRUE(fs::exists(answer.report / "index.html"));
    EXPECT_THAT(readFile(work_.path() / "base" / kRotation), Not(HasSubstr("outerProduct(")));
    EXPECT_EQ(commitOf("base", "HEAD"), commitOf("base", "main"));
}

TEST_F(PullRequestTest, TheShareToPassIsConfigurable) {
    std::string half = solved(kRotation);
    const std::size_t at = half.find("// BEGIN TODO(rotation)");
    half.insert(half.find('\n', at) + 1, "    return glm::mat3(1.0f);\n");
    write(kRotation, half);
    const Answer strict = grade("PASS_FROM=60");
    EXPECT_EQ(strict.exitCode, 1) << strict.log;
    EXPECT_THAT(strict.summary, HasSubstr("Not passed yet; the check passes from 60 points on"));
    EXPECT_THAT(strict.outputs, HasSubstr("passed=false"));
    // What was lost is said at the line of the student's TODO region.
    const auto line = 1 + std::count(half.begin(), half.begin() + static_cast<long>(at), '\n');
    EXPECT_THAT(strict.log,
                HasSubstr(fmt::format("::warning file={},line={},title=", kRotation, line)));
    EXPECT_EQ(graded(commitOf("student", "HEAD"), "PASS_FROM=40").exitCode, 0);
}

TEST_F(PullRequestTest, CompileErrorsAreRemarksAtTheirLines) {
    write(kRotation, "#include \"rotation.h\"\n\nint oops = \"::error::forged\";\n");
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 1) << answer.log;
    EXPECT_THAT(answer.log,
                HasSubstr(fmt::format("::error file={},line=3,col=12,title=", kRotation)));
    EXPECT_THAT(answer.summary,
                HasSubstr("The first compile error:\n\n```text\nrotation.cpp:3:12"));
}

TEST_F(PullRequestTest, AShaderThatDoesNotCompileIsOneRemarkAtItsLine) {
    const std::string shader = "assignments/10-lighting/shaders/lighting.frag";
    const std::string broken = withRegion(solved(shader), "emission", "\noops\n").value();
    write(shader, broken);
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 1) << answer.log;
    const auto line =
        1 + std::count(broken.begin(), broken.begin() + long(broken.find("oops")), '\n');
    // The parser names the line of `oops`, or that of the token after it.
    const std::string remark = "::error file=" + shader + ",line=";
    const std::size_t at = answer.log.find(remark);
    ASSERT_NE(at, std::string::npos) << answer.log;
    EXPECT_NEAR(std::stoi(answer.log.substr(at + remark.size())), line, 2);
    EXPECT_EQ(answer.log.find("::error ", at + 1), std::string::npos) << answer.log;
    EXPECT_THAT(answer.log, AllOf(Not(HasSubstr("::warning ")), Not(HasSubstr("%0A%0A"))));
    EXPECT_THAT(answer.summary,
                AllOf(HasSubstr("The first compile error:\n\n```text\nshaders/lighting.frag:"),
                      HasSubstr("| 0 / 10 | shaders/lighting.frag does not compile |")));
}

TEST_F(PullRequestTest, EditedGraderTestsAndWorkflowsHaveNoEffectAndAreNamed) {
    write("grader/README", "a better one");
    write(".github/workflows/grade.yml", "on: push\njobs: {}\n");
    write(".github/actions/grade/grade.sh", "#!/bin/sh\nexit 0\n");
    write("assignments/06-rotation/tests/CrossMatrix_test.cpp", "// none\n");
    write("assignments/06-rotation/assignment.json", "{}\n");
    write("solutions/06-rotation/rotation.cpp", solved(kRotation));
    write(kRotation, readFile(student() / kRotation) + "// begun\n");
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 1) << answer.log;
    EXPECT_THAT(answer.summary,
                AllOf(HasSubstr("06-rotation Rotation: 0 / 100"), HasSubstr("### Not used"),
                      HasSubstr("* `grader/README`"), HasSubstr("* `.github/workflows/grade.yml`"),
                      HasSubstr("* `assignments/06-rotation/tests/CrossMatrix_test.cpp`")));
    EXPECT_THAT(answer.log, HasSubstr("have no effect on the result, nor those to 5 other files"));
}

TEST_F(PullRequestTest, OfNothingToGradeTheSummarySaysSo) {
    write("notes.txt", "hello");
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
    EXPECT_THAT(answer.summary, AllOf(HasSubstr("Nothing to grade"), HasSubstr("* `notes.txt`")));
    EXPECT_EQ(answer.outputs, "points=0\nmax-points=0\npassed=true\n");
    EXPECT_FALSE(fs::exists(answer.report));
}

TEST_F(PullRequestTest, WorkInTheWrongPlaceDoesNotPass) {
    write("rotation.cpp", solved(kRotation));
    write("assignments/06-rotation/Rotation.cpp", solved(kRotation));
    write("work/transformed_normal.vert", "// mine\n");
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 1) << answer.log;
    EXPECT_THAT(
        answer.summary,
        AllOf(HasSubstr("Nothing to grade"),
              HasSubstr("* assignments/06-rotation/Rotation.cpp is not graded where it is: rename "
                        "it to assignments/06-rotation/rotation.cpp"),
              HasSubstr("rename it to assignments/07-camera/shaders/transformed\\_normal.vert")));
    EXPECT_THAT(answer.log, HasSubstr("::error title=in the wrong place::"));
    EXPECT_THAT(answer.outputs, HasSubstr("passed=false"));
    // Beside the right one a copy is only not used.
    write(kRotation, solved(kRotation));
    fs::remove_all(student() / "work");
    const Answer right = grade();
    EXPECT_EQ(right.exitCode, 0) << right.log;
    EXPECT_THAT(right.summary, AllOf(HasSubstr("100 / 100"), HasSubstr("* `rotation.cpp`")));
}

TEST_F(PullRequestTest, AnEmptyPullRequestIsNothingToGrade) {
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
    EXPECT_THAT(answer.summary, AllOf(HasSubstr("Nothing to grade"), Not(HasSubstr("Not used"))));
}

TEST_F(PullRequestTest, TwoAssignmentsTheOneTakesTheOthersFile) {
    write(kRotation, solved(kRotation));
    for (const char* name : {"Camera.h", "shaders/transformed_normal.vert"})
        write(fmt::format("assignments/07-camera/{}", name),
              solved(fmt::format("assignments/07-camera/{}", name)));
    const std::string begun = regionsOf(readFile(student() / kCamera)).at("perspective");
    write(kCamera, withRegion(solved(kCamera), "perspective", begun).value());
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
    EXPECT_THAT(answer.summary, AllOf(HasSubstr("06-rotation Rotation: 100 / 100"),
                                      HasSubstr("07-camera"), Not(HasSubstr("08-perspective"))));
    EXPECT_THAT(answer.outputs, HasSubstr("points=200\nmax-points=200"));
}

TEST_F(PullRequestTest, ATaskInAFileOfAnEarlierAssignmentIsGradedForItsOwn) {
    const std::string right = regionsOf(solved(kCamera)).at("perspective");
    write(kCamera, withRegion(readFile(student() / kCamera), "perspective", right).value());
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 1) << "of 07 nothing is solved\n" << answer.log;
    EXPECT_THAT(answer.summary, HasSubstr("08-perspective Perspective: 45 / 100"));
    // Lost, it is remarked where it is.
    write(kCamera,
          withRegion(readFile(student() / kCamera), "perspective", "    proj = glm::mat4(1.0f);\n")
              .value());
    const std::string text = readFile(student() / kCamera);
    const auto line =
        1 + std::count(text.begin(), text.begin() + long(text.find("// BEGIN TODO(perspective)")),
                       '\n');
    EXPECT_THAT(grade().log, HasSubstr(fmt::format("::warning file={},line={},title=The "
                                                   "perspective projection",
                                                   kCamera, line)));
}

TEST_F(PullRequestTest, FilesThatWereCarriedForwardCountWhereTheyAre) {
    write(kRotation, solved(kRotation));
    write("assignments/08-perspective/projection.cpp",
          solved("assignments/08-perspective/projection.cpp"));
    for (const char* name : {"Camera.h", "Camera.cpp"})
        write(fmt::format("assignments/08-perspective/{}", name),
              solved(fmt::format("assignments/07-camera/{}", name)));
    const Answer answer = grade();
    EXPECT_THAT(answer.summary, AllOf(HasSubstr("08-perspective Perspective: 100 / 100"),
                                      Not(HasSubstr("Not used")), Not(HasSubstr("07-camera"))));
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
}

TEST_F(PullRequestTest, ARenamedFileIsNotReadAndThatIsSaid) {
    sh("cd student && git mv " + std::string(kRotation) + " assignments/06-rotation/Rotation.cpp");
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 1) << answer.log;
    EXPECT_THAT(answer.summary, AllOf(HasSubstr("was renamed to"), HasSubstr("0 / 100")));
}

TEST_F(PullRequestTest, LinksAndGiantFilesAreNotTaken) {
    fs::remove(student() / kRotation);
    fs::create_symlink("/etc/passwd", student() / kRotation);
    write("assignments/07-camera/Camera.cpp", std::string(5u << 20, 'x'));
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 1) << answer.log;
    EXPECT_THAT(answer.summary,
                AllOf(HasSubstr("is no regular file and was not taken"),
                      HasSubstr("has more than 4 MiB and was not taken"), Not(HasSubstr("root:"))));
}

TEST_F(PullRequestTest, AFolderInAFilesPlaceIsNotTaken) {
    fs::remove(student() / kRotation);
    write(std::string(kRotation) + "/more.cpp", "int more;\n");
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 1) << answer.log;
    EXPECT_THAT(answer.summary, AllOf(HasSubstr("## 06-rotation Rotation: 0 / 100"),
                                      HasSubstr("is no regular file and was not taken")));
}

TEST_F(PullRequestTest, AForkWithUnrelatedHistoryIsGraded) {
    sh("rm -rf student/.git && cd student && git init -q -b work && git remote add origin "
       "../hub.git");
    write(kRotation, solved(kRotation));
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
    EXPECT_THAT(answer.summary, HasSubstr("06-rotation Rotation: 100 / 100"));
}

TEST_F(PullRequestTest, NamesOfAnyLetterAndHugeNumbersOfFilesAreListedShort) {
    for (int i = 0; i < 1500; ++i)
        write(fmt::format("my notes/größe `<b>{}.txt", i), "x");
    write("a\nb::error::forged", "x");
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
    EXPECT_THAT(answer.summary, AllOf(HasSubstr("größe"), HasSubstr("and many more")));
    EXPECT_LT(answer.summary.size(), 10000u);
    EXPECT_THAT(answer.log, Not(HasSubstr("\nb::error")));
}

// Ten folders of ten folders of … take 200 bytes a level, and no disk could hold them. git is ended
// before it has listed one.
TEST_F(PullRequestTest, ATreeThatUnfoldsWithoutEndIsListedShort) {
    write(kRotation, solved(kRotation));
    commit("my work", "HEAD:refs/heads/mine");
    sh("cd student && tree=$(printf '100644 blob %s\tx\n' $(echo x | git hash-object -w --stdin)"
       " | git mktree) && for level in $(seq 12); do tree=$(for each in $(seq 10); do"
       " printf '040000 tree %s\t%s\n' $tree $each; done | git mktree); done &&"
       " tree=$({ git ls-tree HEAD; printf '040000 tree %s\tbomb\n' $tree; } | git mktree) &&"
       " commit=$(git commit-tree -m bomb -p HEAD $tree) && git update-ref refs/heads/bomb $commit"
       " && git push -q origin +$commit:refs/pull/7/head");
    const Answer answer = graded(commitOf("student", "bomb"));
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
    EXPECT_THAT(answer.summary,
                AllOf(HasSubstr("06-rotation Rotation: 100 / 100"), HasSubstr("* and many more")));
    EXPECT_LT(answer.summary.size(), 10000u);
}

TEST_F(PullRequestTest, ANameThatNoDiskTakesIsOnlyListed) {
    write(kRotation, solved(kRotation));
    commit("my work", "HEAD:refs/heads/mine");
    sh("cd student && blob=$(echo x | git hash-object -w --stdin) && tree=$({ git ls-tree HEAD;"
       " printf '100644 blob %s\t%0300d\n' $blob 7; } | git mktree) &&"
       " commit=$(git commit-tree -m long -p HEAD $tree) && git update-ref refs/heads/long $commit"
       " && git push -q origin +$commit:refs/pull/7/head");
    const Answer answer = graded(commitOf("student", "long"));
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
    EXPECT_THAT(answer.summary, AllOf(HasSubstr("06-rotation Rotation: 100 / 100"),
                                      HasSubstr(std::string(199, '0') + "…")));
}

TEST_F(PullRequestTest, WhatAStudentPrintsIsNeitherACommandNorMarkup) {
    std::string loud = solved(kRotation);
    const std::size_t at = loud.find('\n', loud.find("// BEGIN TODO(cross-matrix)"));
    loud.insert(
        at + 1,
        "    for (int i = 0; i < 100000; ++i)\n"
        "        std::puts(\"::error::forged\\n::add-mask::a\\n```\\n# forged\\n| <img>\");\n");
    write(kRotation, "#include <cstdio>\n" + loud);
    const Answer answer = grade("PASS_FROM=80");
    EXPECT_EQ(answer.exitCode, 1) << answer.log;
    EXPECT_LT(answer.summary.size(), 100000u);
    EXPECT_THAT(answer.summary, AllOf(Not(HasSubstr("\n# forged")), Not(HasSubstr("<img>"))));
    // Between the word that stops commands and the same word again, nothing is one.
    const std::string start = "::stop-commands::";
    const std::size_t from = answer.log.find(start);
    ASSERT_NE(from, std::string::npos) << answer.log;
    const std::string word = answer.log.substr(from + start.size(), 28);
    const std::size_t to = answer.log.find("::" + word + "::", from + start.size());
    ASSERT_NE(to, std::string::npos) << answer.log;
    EXPECT_THAT(answer.log.substr(0, from) + answer.log.substr(to),
                AllOf(Not(HasSubstr("\n::error::forged")), Not(HasSubstr("::add-mask"))));
}

TEST_F(PullRequestTest, WhatTheBaseChangedMeanwhileIsNotTheStudents) {
    // The instructor changes the starter of 07, the student merges that and works on 06; the event
    // still names the base of before.
    sh("cd base && echo '// mended' >> assignments/07-camera/Camera.cpp && git commit -qam mended "
       "&& git push -q origin main && cd ../student && git pull -q origin main");
    write(kRotation, solved(kRotation));
    const Answer answer = grade();
    EXPECT_EQ(answer.exitCode, 0) << answer.log;
    EXPECT_THAT(answer.summary, HasSubstr("## 06-rotation Rotation: 100 / 100"));
    EXPECT_THAT(answer.summary, Not(HasSubstr("07-camera")));
}

TEST_F(PullRequestTest, ThatThereIsNoMarkIsSaidInTheSummaryToo) {
    write(kRotation, solved(kRotation));
    commit("my work", "+HEAD:refs/pull/7/head");
    const fs::path summary = work_.path() / "fault";
    const lab::Graded fault = lab::runGrader({"pull-request", "--base", std::string(40, 'a'),
                                              "--head", commitOf("student", "HEAD"), "--repository",
                                              student().string(), "--summary", summary.string()});
    EXPECT_EQ(fault.exitCode, 2);
    EXPECT_THAT(fault.text, HasSubstr("has no commit " + std::string(40, 'a') + ", the base"));
    EXPECT_THAT(readFile(summary), HasSubstr("this is not your mistake, and no mark"));
}

TEST_F(PullRequestTest, ACommitThatIsGoneOrNoPullRequestIsAClearError) {
    write(kRotation, solved(kRotation));
    commit("my work", "+HEAD:refs/pull/7/head");
    const Answer answer = graded(std::string(40, 'a'));
    EXPECT_EQ(answer.exitCode, 2);
    EXPECT_THAT(answer.log, HasSubstr("has moved on from aaaa"));
    writeFile(work_.path() / "event.json", "{}");
    const ProcessResult script =
        run({"env", "GITHUB_EVENT_PATH=" + (work_.path() / "event.json").string(),
             (lab::root() / ".github/actions/grade/grade.sh").string(), COURSE_GRADER},
            60);
    EXPECT_EQ(script.exitCode, 2);
    EXPECT_THAT(script.output, HasSubstr("does not tell of a pull request"));
    const lab::Graded none = lab::runGrader({"pull-request", "--event", "/dev/null"});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_THAT(none.text, HasSubstr("expected the event of a pull request"));
    const lab::Graded odd =
        lab::runGrader({"pull-request", "--base", "--output=x", "--head", "main"});
    EXPECT_EQ(odd.exitCode, 2);
}

}  // namespace
