// A folder of submissions, graded by one command: every one gets its result, and none is lost.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <random>

#include "BatchLab.h"

namespace {

using lab::BatchTest;
using lab::Graded;
using lab::Json;
using lab::kRotation;
using lab::Submission;
using testing::HasSubstr;
using testing::Not;
namespace fs = lab::fs;

TEST_F(BatchTest, EverySubmissionHasAResultAndIsGradedOnce) {
    const Graded first = batch({"--jobs", "2"});
    EXPECT_EQ(first.exitCode, 0) << first.text;
    EXPECT_THAT(first.text, HasSubstr("4 of 4 submissions have a result"));
    EXPECT_EQ(student("honest").at("points"), 100.0);
    EXPECT_EQ(student("half").at("points"), 75.0);
    EXPECT_EQ(student("half").at("tasks").at(0).at("points"), 0.0);
    EXPECT_EQ(student("broken").at("status"), "build_error");
    EXPECT_EQ(student("text").at("status"), "refused");
    EXPECT_THAT(student("text").at("sentence").get<std::string>(), HasSubstr("no zip"));
    EXPECT_TRUE(fs::exists(out() / "students/half/report/index.html"));
    EXPECT_THAT(lab::readFile(out() / "index.html"), HasSubstr("instructor/half/report/index.html"))
        << "the seed is secret: an instructor's report has what students must not see";
    EXPECT_THAT(lab::readFile(out() / "index.html"), HasSubstr("list.txt: neither"));

    const Json before = students();
    Submission changed;
    changed.solve(kRotation, "euler-rodrigues", "    return glm::mat3(0.0f);\n");
    fs::remove_all(home() / "honest");
    put("honest", changed);
    const Graded second = batch();
    EXPECT_EQ(second.exitCode, 0) << second.text;
    EXPECT_THAT(second.text, HasSubstr("half 75 of 100 (as before)"));
    EXPECT_THAT(second.text, Not(HasSubstr("honest 70 of 100 (as before)")));
    EXPECT_EQ(student("honest").at("points"), 70.0);
    for (const char* same : {"half", "broken", "text"})
        for (const Json& each : before)
            if (each.at("student") == same) {
                EXPECT_EQ(student(same), each);
            }
    EXPECT_THAT(batch({"--fresh"}).text, Not(HasSubstr("as before")));
}

TEST_F(BatchTest, GradedThreeTimesHonestWorkComesOutAlike) {
    lab::writeFile(home() / "alone.cpp", Submission().read(kRotation));
    const Graded stable = batch({"--stable"});
    EXPECT_EQ(stable.exitCode, 0) << stable.text;
    EXPECT_EQ(student("alone").at("points"), 100.0);
    for (const Json& each : students())
        EXPECT_TRUE(each.at("warnings").empty()) << each.dump(2);
    EXPECT_THAT(lab::readFile(out() / "students/half/report.txt"), HasSubstr("75 / 100"));
    EXPECT_THAT(batch({"--stable"}).text, HasSubstr("half 75 of 100 (as before)"));
    EXPECT_THAT(batch().text, Not(HasSubstr("half 75 of 100 (as before)")))
        << "graded once is another thing than graded three times";
}

TEST_F(BatchTest, BadInputIsNamed) {
    EXPECT_EQ(batch({"--seed", "1"}).exitCode, 0);
    const Graded other = lab::runGrader(
        {"batch", home().string(), "--assignment", "07-camera", "--out", out().string()});
    EXPECT_EQ(other.exitCode, 2);
    EXPECT_THAT(other.text, HasSubstr("holds results of 06-rotation, not of 07-camera"));
    const Graded missing = lab::runGrader({"batch", (home() / "nowhere").string(), "--assignment",
                                           "06-rotation", "--out", out().string()});
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_THAT(missing.text, HasSubstr("there is no such folder"));
    for (const char* part : {"1/-1", "0/2", "3/2", "1/2x"}) {
        const Graded refused = batch({"--shard", part});
        EXPECT_EQ(refused.exitCode, 2) << part;
        EXPECT_THAT(refused.text, HasSubstr("expected a part of a whole like 2/8"));
    }
}

TEST_F(BatchTest, WhatIsKeptAndDamagedIsNamedOrGradedAgain) {
    ASSERT_EQ(batch().exitCode, 0);
    lab::writeFile(out() / "students/half/result.json", "{}");
    lab::writeFile(out() / "instructor/honest/record.json", "[]");
    lab::writeFile(out() / "results.json", R"({"assignment": "06-rotation", "students": [{}]})");
    const Graded exported = lab::runGrader({"export", out().string(), "--to", "csv"});
    EXPECT_EQ(exported.exitCode, 2);
    EXPECT_THAT(exported.text, HasSubstr("results.json is not as ./grade batch wrote it"));
    EXPECT_THAT(exported.text, HasSubstr("run the same ./grade batch again"));
    const Graded again = batch();
    EXPECT_EQ(again.exitCode, 0) << again.text;
    EXPECT_THAT(again.text, Not(HasSubstr("half 75 of 100 (as before)")));
    EXPECT_EQ(student("half").at("points"), 75.0);
    EXPECT_EQ(student("honest").at("points"), 100.0);
    lab::writeFile(out() / "students/half/result.json", R"({"tasks": [{}]})");
    EXPECT_THAT(lab::runGrader({"export", out().string(), "--to", "junit"}).text,
                HasSubstr("half/result.json is not as"));
    lab::writeFile(out() / "batch.json", "{}");
    EXPECT_THAT(batch().text, HasSubstr("batch.json is not as"));
}

TEST_F(BatchTest, NamesThatStudentsChooseAreShownHarmless) {
    const std::string name = "e\x1b[31m\n::error::\xff";
    lab::writeFile(home() / (name + ".zip"), "my homework");
    lab::writeFile(home() / (name + ".txt"), "");
    const Graded graded = batch();
    EXPECT_EQ(graded.exitCode, 0) << graded.text;
    EXPECT_THAT(graded.text, HasSubstr("e [31m ::error::?: refused"));
    EXPECT_THAT(graded.text, HasSubstr("Look at: e [31m ::error::?.txt: neither"));
    const std::string table = lab::readFile(out() / "results.csv");
    EXPECT_THAT(table, HasSubstr("e [31m ::error::?,"));
    for (const std::string& each : {graded.text, table}) {
        EXPECT_THAT(each, Not(HasSubstr("\x1b")));
        EXPECT_THAT(each, Not(HasSubstr("\n::error::")));
        EXPECT_THAT(each, Not(HasSubstr("\xff")));
    }
}

TEST_F(BatchTest, ARepositoryIsReadFromItsCommitAndRunsNothing) {
    const fs::path clone = home() / "clone", trace = work_.path() / "trace";
    Submission half;
    half.solve(kRotation, "cross-matrix", "    return glm::mat3(0.0f);\n");
    fs::create_directories(clone);
    fs::copy(half.folder() / "06-rotation", clone / "06-rotation", fs::copy_options::recursive);
    const auto made = lab::run(
        {"bash", "-ec",
         "cd \"$0\"; git init -q .; git add .; "
         "git -c user.name=x -c user.email=x@x commit -q -m work; "
         "git config core.fsmonitor \"touch $1\"; git config core.pager \"touch $1\"; "
         "git config core.sshCommand \"touch $1\"; "
         "for hook in post-checkout pre-commit reference-transaction post-index-change; do "
         "printf '#!/bin/sh\\ntouch %s\\n' \"$1\" > .git/hooks/$hook; chmod +x .git/hooks/$hook; "
         "done; "
         "echo '* filter=evil' > .git/info/attributes; git config filter.evil.smudge \"touch $1\"; "
         "echo broken > 06-rotation/rotation.cpp",
         clone.string(), trace.string()},
        30);
    ASSERT_TRUE(made.succeeded()) << made.output;
    fs::remove(trace);  // git itself may have run what it was told to
    fs::create_directories(home() / "empty-repository");
    ASSERT_TRUE(
        lab::run({"git", "init", "-q", (home() / "empty-repository").string()}, 10).succeeded());
    const Graded graded = batch();
    EXPECT_EQ(graded.exitCode, 0) << graded.text;
    EXPECT_EQ(student("clone").at("points"), 75.0) << "what is committed, not what lies there";
    EXPECT_EQ(student("empty-repository").at("status"), "refused");
    EXPECT_FALSE(fs::exists(trace)) << "something of the repository was run";
}

TEST_F(BatchTest, ARepositoryWithoutEndIsRefused) {
    // A commit of ten folders in each of ten folders, nine times, and no file in any.
    const auto made =
        lab::run({"bash", "-ec",
                  "git init -q \"$0\"; cd \"$0\"; tree=$(git mktree < /dev/null); "
                  "for level in 1 2 3 4 5 6 7 8 9; do tree=$(for i in 0 1 2 3 4 5 6 7 8 9; do "
                  "printf '040000 tree %s\\t%s\\n' $tree $i; done | git mktree); done; "
                  "commit=$(git -c user.name=x -c user.email=x@x commit-tree -m work $tree); "
                  "git update-ref HEAD $commit",
                  (home() / "bomb").string()},
                 30);
    ASSERT_TRUE(made.succeeded()) << made.output;
    const Graded graded = batch();
    EXPECT_EQ(graded.exitCode, 0) << graded.text;
    EXPECT_EQ(student("bomb").at("status"), "refused");
    EXPECT_THAT(graded.text, HasSubstr("it could not be read within 20 s"));
}

/// The class that the README grades, see grader/examples/class.
class ExampleClass : public testing::Test {
protected:
    fs::path home() const { return lab::root() / "grader/examples/class"; }
    fs::path out(const std::string& name) const { return work_.path() / name; }
    Graded batch(const std::string& name, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments = {"batch",        (home() / "submissions").string(),
                                              "--assignment", "06-rotation",
                                              "--seed",       "7",
                                              "--out",        out(name).string(),
                                              "--roster",     (home() / "roster.csv").string(),
                                              "--times",      (home() / "times.csv").string(),
                                              "--policy",     (home() / "policy.json").string(),
                                              "--overrides",  (home() / "overrides.csv").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return lab::runGrader(arguments);
    }
    Json student(const std::string& id) const {
        const Json results = lab::parseJsonFile((out("all") / "results.json").string());
        for (const Json& each : results.at("students"))
            if (each.at("student") == id)
                return each;
        return nullptr;
    }

    lab::WorkFolder work_;
};

TEST_F(ExampleClass, KilledAtFiftyMomentsItEndsAsIfUndisturbed) {
    const auto run = [&](const std::string& to, const std::string& wrapper) {
        return lab::run({"bash", "-c",
                         wrapper + " \"$0\" batch \"$1\" --assignment 06-rotation --seed 9 --out "
                                   "\"$2\" --quiet",
                         COURSE_GRADER, (home() / "submissions").string(), out(to).string()},
                        240);
    };
    ASSERT_TRUE(run("undisturbed", "").succeeded());
    std::mt19937 random(50);
    int kills = 0;
    // Most are killed while they grade; once all is graded, while they read what they know.
    for (int attempt = 0; attempt < 400 && kills < 50; ++attempt) {
        const bool graded = fs::exists(out("killed") / "results.json");
        const auto wait = graded ? 5 + random() % 60 : 50 + random() % 800;
        kills += !run("killed", fmt::format("timeout -s KILL 0.{:03}", wait)).succeeded();
    }
    EXPECT_EQ(kills, 50);
    ASSERT_TRUE(run("killed", "").succeeded());
    EXPECT_EQ(lab::readFile(out("killed") / "results.csv"),
              lab::readFile(out("undisturbed") / "results.csv"));
    const auto folders = fs::directory_iterator(out("killed") / "students");
    EXPECT_EQ(std::distance(begin(folders), end(folders)), 30) << "each is accounted for once";
}

TEST_F(ExampleClass, IsGradedExportedReplayedAndMerged) {
    const Graded all = batch("all");
    ASSERT_EQ(all.exitCode, 0) << all.text;
    EXPECT_THAT(all.text, HasSubstr("30 of 30 submissions have a result"));
    EXPECT_THAT(all.text, HasSubstr("Look at: 1030 is not in the roster"));
    EXPECT_EQ(student("1031").at("status"), "missing");
    EXPECT_EQ(student("1011").at("late").at("percent"), 10.0);
    EXPECT_NEAR(student("1011").at("points").get<double>(),
                0.9 * student("1011").at("automatic").get<double>(), 1e-5);
    EXPECT_FALSE(student("1019").contains("late")) << "it has an extension";
    EXPECT_EQ(student("1007").at("points"), 100.0) << "the second submission counts";
    EXPECT_EQ(student("1025").at("points"), 100.0) << "out of an archive";
    EXPECT_EQ(student("1021").at("status"), "build_error");
    EXPECT_EQ(student("1021").at("points"), 20.0) << "a person's decision";
    EXPECT_EQ(student("1004").at("points"), 0.0);
    const Json results = lab::parseJsonFile((out("all") / "results.json").string());
    bool copied = false;
    for (const Json& each : results.at("alike"))
        copied = copied || each.at("submissions") == Json{"student028_1028", "student029_1029"};
    EXPECT_TRUE(copied) << results.at("alike").dump(2);

    const fs::path frame = "report/06-rotation/seeded-turn.reference.png";
    EXPECT_FALSE(fs::exists(out("all") / "students/student001_1001" / frame));
    EXPECT_TRUE(
        fs::exists(out("all") / "students/student001_1001/report/06-rotation/turned.reference.png"))
        << "what does not depend on the seed is published anyway";
    EXPECT_TRUE(fs::exists(out("all") / "instructor/student001_1001" / frame));

    const Graded replayed =
        lab::runGrader({"replay", (out("all") / "students/student003_1003").string()});
    EXPECT_EQ(replayed.exitCode, 0) << replayed.text;
    EXPECT_THAT(replayed.text, HasSubstr("the mark agrees"));

    const Graded exported = lab::runGrader({"export", out("all").string(), "--to", "canvas",
                                            "--into", (home() / "gradebook.csv").string()});
    EXPECT_EQ(exported.exitCode, 0) << exported.text;
    EXPECT_THAT(exported.text, HasSubstr("29 marks written"));
    EXPECT_THAT(lab::readFile(out("all") / "export/canvas.csv"),
                HasSubstr("\"07, Student\",1007,,student007@example.edu,A,20.00,"));
    for (const char* each :
         {"gradescope", "prairielearn", "classroom50", "autolab", "junit", "csv"})
        EXPECT_EQ(lab::runGrader({"export", out("all").string(), "--to", each}).exitCode, 0)
            << each;

    ASSERT_EQ(batch("one", {"--shard", "1/2"}).exitCode, 0);
    ASSERT_EQ(batch("two", {"--shard", "2/2"}).exitCode, 0);
    const Graded merged = lab::runGrader(
        {"merge", out("two").string(), out("one").string(), "--out", out("merged").string()});
    EXPECT_EQ(merged.exitCode, 0) << merged.text;
    EXPECT_EQ(lab::readFile(out("merged") / "results.csv"),
              lab::readFile(out("all") / "results.csv"));
}

}  // namespace
