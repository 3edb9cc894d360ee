// A folder of submissions, graded by one command: every one gets its result, and none is lost.

#include <gmock/gmock.h>

#include "Lab.h"

namespace {

using lab::Graded;
using lab::Json;
using lab::Submission;
using testing::HasSubstr;
using testing::Not;
namespace fs = lab::fs;

const std::string kRotation = "06-rotation/rotation.cpp";

class BatchTest : public testing::Test {
protected:
    BatchTest() {
        fs::create_directories(home());
        put("honest", Submission());
        Submission half;
        half.solve(kRotation, "cross-matrix", "    return glm::mat3(0.0f);\n");
        put("half", half);
        Submission broken;
        broken.write(kRotation, "this is no C++\n");
        put("broken", broken);
        lab::writeFile(home() / "text.zip", "my homework");
        lab::writeFile(home() / "list.txt", "alpha, beta");
    }

    fs::path home() const { return work_.path() / "submissions"; }
    fs::path out() const { return work_.path() / "out"; }
    void put(const std::string& name, const Submission& submission) const {
        fs::create_directories(home() / name);
        fs::copy(submission.folder() / "06-rotation", home() / name / "06-rotation",
                 fs::copy_options::recursive);
    }
    Graded batch(std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments = {"batch",       home().string(), "--assignment",
                                              "06-rotation", "--out",         out().string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return lab::runGrader(arguments);
    }
    Json students() const {
        return lab::parseJsonFile((out() / "results.json").string()).at("students");
    }
    Json student(const std::string& name) const {
        for (const Json& each : students())
            if (each.at("student") == name)
                return each;
        return nullptr;
    }

    lab::WorkFolder work_;
};

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

TEST_F(BatchTest, GoesOnWhereItWasKilled) {
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
}

}  // namespace
