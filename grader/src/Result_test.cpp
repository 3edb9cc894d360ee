#include "Result.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Fields.h"
#include "testing/Results.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing_help::check;
using testing_help::sampleResult;
using testing_help::task;

std::vector<std::string> namesOf(const Json& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.items())
        names.push_back(name);
    return names;
}

Json documentOf(const AssignmentResult& result) {
    return Json::parse(toJson(result));
}

Status statusOf(std::vector<Status> checks) {
    Manifest manifest;
    manifest.tasks = {{"look-at", "View", "", 100, {}}};
    std::vector<CheckResult> all;
    for (const Status each : checks) {
        all.push_back(check("x", each, each == Status::pass || each == Status::partial ? 1 : 0, 1));
        all.back().task = "look-at";
    }
    return groupByTask(manifest, all).at(0).status;
}

TEST(ResultDocument, HasTheFieldsInTheirOrder) {
    AssignmentResult result = sampleResult();
    result.diagnostics = {{"Camera.cpp", 3, 4, "warning", "unused", "int x;"}};
    CheckResult& frame = result.tasks[0].checks[0];
    frame.kind = "frame";
    frame.imagePaths = {{"difference", "d"}, {"reference", "r"}, {"submission", "s"}};
    const Json document = documentOf(result);
    EXPECT_THAT(namesOf(document),
                ElementsAre("format", "assignment", "title", "status", "points", "max_points",
                            "seed", "build", "tasks", "inherited", "ignored_files", "notices",
                            "environment", "timing"));
    EXPECT_THAT(namesOf(document["build"]), ElementsAre("ok", "diagnostics"));
    EXPECT_THAT(namesOf(document["build"]["diagnostics"][0]),
                ElementsAre("file", "line", "column", "severity", "message", "source"));
    EXPECT_THAT(namesOf(document["tasks"][0]),
                ElementsAre("id", "title", "points", "max_points", "status", "checks"));
    const Json& first = document["tasks"][0]["checks"][0];
    EXPECT_THAT(namesOf(first), ElementsAre("id", "kind", "title", "status", "points", "max_points",
                                            "message", "hint", "images"));
    EXPECT_THAT(namesOf(first["images"]), ElementsAre("submission", "reference", "difference"));
    EXPECT_THAT(
        namesOf(document["environment"]),
        ElementsAre("grader", "compiler", "glm", "gl_renderer", "gl_version", "cpu", "sandbox"));
}

TEST(ResultDocument, HasTheValues) {
    AssignmentResult result = sampleResult();
    result.seed = 0xffffffffffffffff;
    result.inherited = {{"rotation.cpp", "solutions"}};
    result.ignoredFiles = {"extra.cpp", "tests/"};
    const Json document = documentOf(result);
    EXPECT_EQ(document["format"], 1);
    EXPECT_EQ(document["status"], "graded");
    EXPECT_EQ(document["points"], 75);
    EXPECT_EQ(document["max_points"], 100);
    EXPECT_EQ(document["seed"], 0xffffffffffffffff);
    EXPECT_EQ(document["build"]["ok"], true);
    EXPECT_EQ(document["tasks"][1]["checks"][1]["status"], "fail");
    EXPECT_EQ(document["tasks"][1]["checks"][1]["hint"], "Turn up too.");
    EXPECT_FALSE(document["tasks"][1]["checks"][1].contains("images"));
    EXPECT_EQ(document["inherited"]["rotation.cpp"], "solutions");
    EXPECT_EQ(document["ignored_files"], Json({"extra.cpp", "tests/"}));
    EXPECT_EQ(document["environment"]["gl_renderer"], "llvmpipe");
}

TEST(ResultDocument, EmptyCollectionsKeepTheirKind) {
    AssignmentResult result;
    const Json document = documentOf(result);
    EXPECT_TRUE(document["tasks"].is_array());
    EXPECT_TRUE(document["build"]["diagnostics"].is_array());
    EXPECT_TRUE(document["ignored_files"].is_array());
    EXPECT_TRUE(document["notices"].is_array());
    EXPECT_TRUE(document["inherited"].is_object());
    EXPECT_TRUE(document["timing"].is_object());
}

TEST(ResultDocument, TimesStandUnderTimingAndNowhereElse) {
    AssignmentResult one = sampleResult(), other = sampleResult();
    other.timing = {{"total_seconds", 99.0}, {"build_seconds", 3.0}};
    Json first = documentOf(one), second = documentOf(other);
    EXPECT_NE(first.dump(), second.dump());
    first.erase("timing");
    second.erase("timing");
    EXPECT_EQ(first.dump(), second.dump());
}

TEST(ResultDocument, TextThatIsNotUtf8OrSteersATerminalIsReplaced) {
    AssignmentResult result = sampleResult();
    result.tasks[1].checks[1].message = "threw \xff\x1b[2J \u202egnp\nagain";
    EXPECT_EQ(documentOf(result)["tasks"][1]["checks"][1]["message"], "threw ? [2J  gnp\nagain");
}

TEST(ResultDocument, SumsOfThirdsHaveNoNoise) {
    AssignmentResult result = sampleResult();
    result.tasks = {task("t", Status::pass, {})};
    for (int i = 0; i < 3; ++i)
        result.tasks[0].checks.push_back(check("c", Status::pass, 10.0 / 3, 10.0 / 3));
    result.tasks[0].points = 10.0 / 3 + 10.0 / 3 + 10.0 / 3;
    EXPECT_EQ(documentOf(result)["tasks"][0]["points"].dump(), "10.0");
    EXPECT_EQ(documentOf(result)["tasks"][0]["checks"][0]["points"].dump(), "3.333333");
}

TEST(ResultDocument, OneIsADocumentAndSeveralAreAnArray) {
    EXPECT_TRUE(Json::parse(toJson(std::vector{sampleResult()})).is_object());
    const Json both = Json::parse(toJson(std::vector{sampleResult(), sampleResult()}));
    ASSERT_TRUE(both.is_array());
    EXPECT_EQ(both.size(), 2u);
    EXPECT_EQ(both[1]["assignment"], "07-camera");
}

TEST(TaskStatus, FollowsFromItsChecks) {
    using enum Status;
    EXPECT_EQ(statusOf({pass, pass}), pass);
    EXPECT_EQ(statusOf({pass, fail}), partial);
    EXPECT_EQ(statusOf({fail, partial}), partial);
    EXPECT_EQ(statusOf({notImplemented, notImplemented}), notImplemented);
    EXPECT_EQ(statusOf({notImplemented, crash}), crash);
    EXPECT_EQ(statusOf({notImplemented, fail, crash}), fail);
    EXPECT_EQ(statusOf({buildError, buildError}), buildError);
    EXPECT_EQ(statusOf({pass, graderError}), partial);
}

TEST(GroupByTask, KeepsTheManifestsOrderAndSumsUp) {
    Manifest manifest;
    manifest.tasks = {{"b", "B", "", 60, {}}, {"a", "A", "", 40, {}}};
    std::vector<CheckResult> checks = {check("A.1", Status::pass, 40, 40),
                                       check("B.1", Status::pass, 20, 20),
                                       check("B.2", Status::fail, 0, 40)};
    checks[0].task = "a";
    checks[1].task = checks[2].task = "b";
    const auto tasks = groupByTask(manifest, checks);
    ASSERT_EQ(tasks.size(), 2u);
    EXPECT_EQ(tasks[0].id, "b");
    EXPECT_EQ(tasks[0].points, 20);
    EXPECT_EQ(tasks[0].maxPoints, 60);
    EXPECT_EQ(tasks[0].checks.size(), 2u);
    EXPECT_EQ(tasks[1].status, Status::pass);
}

TEST(GroupByTask, AFrameThatIsOnlyShownDecidesNothing) {
    Manifest manifest;
    manifest.tasks = {{"a", "A", "", 100, {}}};
    std::vector<CheckResult> checks = {check("A.1", Status::pass, 100, 100),
                                       check("shown", Status::timeout, 0, 0)};
    for (CheckResult& each : checks)
        each.task = "a";
    checks[1].kind = "frame";
    EXPECT_EQ(groupByTask(manifest, checks)[0].status, Status::pass);
    checks[1].status = Status::graderError;
    EXPECT_NE(groupByTask(manifest, checks)[0].status, Status::pass);
}

TEST(GroupByTask, ChecksKnowWhenTheyAreShownAndTheDocumentSaysWhereItIsNotAlways) {
    Manifest manifest;
    manifest.tasks = {{"a", "A", "", 100, {}}};
    manifest.visibility = {{"A.2", kAfterDueDate}};
    std::vector<CheckResult> checks = {check("A.1", Status::pass, 50, 50),
                                       check("A.2", Status::pass, 50, 50)};
    for (CheckResult& each : checks)
        each.task = "a";
    AssignmentResult result = sampleResult();
    result.tasks = groupByTask(manifest, checks);
    const Json document = documentOf(result);
    EXPECT_FALSE(document["tasks"][0]["checks"][0].contains("visibility"));
    EXPECT_EQ(document["tasks"][0]["checks"][1]["visibility"], "after_due_date");
}

TEST(AssignmentResult, FullNotStartedAndFailed) {
    AssignmentResult result = sampleResult();
    EXPECT_FALSE(result.full());
    EXPECT_FALSE(result.notStarted());
    EXPECT_FALSE(result.graderFailed());
    result.tasks.pop_back();
    EXPECT_TRUE(result.full());
    result.status = "build_error";
    EXPECT_FALSE(result.full());
    result.status = "graded";
    result.tasks[0].status = Status::notImplemented;
    EXPECT_TRUE(result.notStarted());
    result.tasks[0].checks[0].status = Status::graderError;
    EXPECT_TRUE(result.graderFailed());
}

}  // namespace
