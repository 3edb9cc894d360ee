// A task that no program can judge: pending until a person gives its points.

#include <gmock/gmock.h>

#include "Lab.h"

namespace {

using lab::Graded;
using lab::Json;
using testing::HasSubstr;
namespace fs = lab::fs;

/// A course of its own, in which 06-rotation has a manual task of 5 points.
class ManualTask : public testing::Test {
protected:
    ManualTask() {
        fs::create_directories(course());
        fs::create_directories(program().parent_path());
        for (const char* each : {"assignments", "solutions", "reference_images"})
            fs::copy(lab::root() / each, course() / each, fs::copy_options::recursive);
        const fs::path file = course() / "assignments/06-rotation/assignment.json";
        Json manifest = lab::parseJsonFile(file.string());
        manifest["tasks"][1]["points"] = 40;
        manifest["tasks"].push_back({{"id", "favourite-turn"},
                                     {"title", "Your favourite turn"},
                                     {"points", 5},
                                     {"manual", true}});
        manifest["frames"][1]["task"] = "favourite-turn";
        manifest["frames"][1]["points"] = 0;
        lab::writeFile(file, manifest.dump(4));
        // The grader finds its course by the file beside it.
        const fs::path built = fs::path(COURSE_GRADER).parent_path();
        Json toolchain = lab::parseJsonFile((built / "toolchain.json").string());
        toolchain["root"] = course().string();
        lab::writeFile(program().parent_path() / "toolchain.json", toolchain.dump());
        fs::copy_file(COURSE_GRADER, program());
        lab::writeFile(work_.path() / "class/ann/rotation.cpp",
                       lab::Submission().read("06-rotation/rotation.cpp"));
    }

    fs::path course() const { return work_.path() / "course"; }
    fs::path program() const { return work_.path() / "bin/grader"; }
    fs::path out() const { return work_.path() / "out"; }
    lab::ProcessResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), program().string());
        return lab::run(arguments, 120);
    }
    lab::ProcessResult batch(std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments = {"batch",        (work_.path() / "class").string(),
                                              "--assignment", "06-rotation",
                                              "--seed",       "1",
                                              "--out",        out().string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    /// Lines of a table of --overrides: one point in each task.
    static std::string shown(const std::string& student) {
        std::string lines;
        for (const char* task : {"cross-matrix", "rotation", "euler-rodrigues", "favourite-turn"})
            lines += fmt::format("{},{},1,shown in person\n", student, task);
        return lines;
    }
    Json ann() const {
        return lab::parseJsonFile((out() / "results.json").string()).at("students").at(0);
    }

    lab::WorkFolder work_;
};

TEST_F(ManualTask, IsPendingForTheStudent) {
    const auto graded = run({"06-rotation", "--submission", (work_.path() / "class/ann").string()});
    EXPECT_EQ(graded.exitCode, 0) << graded.output;
    EXPECT_THAT(graded.output, HasSubstr("95 / 100"));
    EXPECT_THAT(graded.output, HasSubstr("… favourite-turn"));
    EXPECT_THAT(graded.output, HasSubstr("a person looks at this and gives the points"));
}

TEST_F(ManualTask, TakesPointsAndASentenceFromATable) {
    const auto first = batch();
    ASSERT_EQ(first.exitCode, 0) << first.output;
    EXPECT_EQ(ann().at("points"), 95.0);
    EXPECT_EQ(ann().at("tasks").at(3).at("pending"), true);
    EXPECT_THAT(lab::readFile(out() / "results.csv"), HasSubstr(",pending,"));
    EXPECT_THAT(lab::readFile(out() / "index.html"),
                HasSubstr("arrow-keys.submission.png\" alt=\"picture of ann\""))
        << "its frame is in the gallery";
    EXPECT_THAT(run({"export", out().string(), "--to", "csv"}).output,
                HasSubstr("ann has no mark yet: favourite-turn is pending"));

    lab::writeFile(
        work_.path() / "o.csv",
        "student,task,points,reason\nann,favourite-turn,4,\"bold, and a little dark\"\n");
    const auto second = batch({"--overrides", (work_.path() / "o.csv").string()});
    ASSERT_EQ(second.exitCode, 0) << second.output;
    EXPECT_EQ(ann().at("points"), 99.0);
    EXPECT_EQ(ann().at("tasks").at(3).value("pending", false), false);
    EXPECT_THAT(ann().at("remarks").at(0).get<std::string>(), HasSubstr("bold, and a little dark"));
    EXPECT_THAT(run({"export", out().string(), "--to", "csv"}).output, HasSubstr("1 mark written"));
}

TEST_F(ManualTask, CountsNowhereBeforeItIsDecided) {
    ASSERT_EQ(batch().exitCode, 0);
    const std::string page = lab::readFile(out() / "index.html");
    const auto from = page.find("id=checks");
    EXPECT_EQ(page.substr(from, page.find("<h2", from) - from).find("favourite"), std::string::npos)
        << "nobody has lost it";
}

TEST_F(ManualTask, AStudentWhoHandedInNothingIsExportedOnceDecided) {
    lab::writeFile(work_.path() / "roster.csv", "id,name\nann,Ann\nbob,Bob\n");
    lab::writeFile(work_.path() / "o.csv",
                   "student,task,points,reason\nann,favourite-turn,4,bold\n" + shown("bob"));
    const auto graded = batch({"--overrides", (work_.path() / "o.csv").string(), "--roster",
                               (work_.path() / "roster.csv").string()});
    ASSERT_EQ(graded.exitCode, 0) << graded.output;
    for (const char* platform :
         {"gradescope", "prairielearn", "classroom50", "autolab", "junit", "csv"}) {
        const auto exported = run({"export", out().string(), "--to", platform});
        EXPECT_EQ(exported.exitCode, 0) << exported.output;
        EXPECT_THAT(exported.output, HasSubstr("2 marks written")) << platform;
    }
    const fs::path bob = out() / "export/gradescope/bob.json";
    EXPECT_EQ(lab::parseJsonFile(bob.string()).at("score"), 4.0);

    // Undecided again: what was exported before must not be uploaded.
    ASSERT_EQ(batch({"--roster", (work_.path() / "roster.csv").string()}).exitCode, 0);
    EXPECT_THAT(run({"export", out().string(), "--to", "gradescope"}).output,
                HasSubstr("bob has no mark"));
    EXPECT_FALSE(fs::exists(bob));
}

TEST_F(ManualTask, TwoStudentsAreNeverExportedToOneFile) {
    lab::writeFile(work_.path() / "roster.csv", "id,name\na/b,One\na_b,Other\n");
    lab::writeFile(work_.path() / "o.csv",
                   "student,task,points,reason\n" + shown("a/b") + shown("a_b"));
    const auto graded = batch({"--overrides", (work_.path() / "o.csv").string(), "--roster",
                               (work_.path() / "roster.csv").string()});
    ASSERT_EQ(graded.exitCode, 0) << graded.output;
    const auto exported = run({"export", out().string(), "--to", "gradescope"});
    EXPECT_EQ(exported.exitCode, 2);
    EXPECT_THAT(exported.output, HasSubstr("a_b.json would be the file of two students"));
    EXPECT_FALSE(fs::exists(out() / "export/gradescope")) << "not one of them";
    EXPECT_EQ(run({"export", out().string(), "--to", "csv"}).exitCode, 0);
}

}  // namespace
