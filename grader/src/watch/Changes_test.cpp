#include "watch/Changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Result.h"
#include "testing/Results.h"
#include "watch/WatchText.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing_help::check;
using testing_help::task;

constexpr TerminalStyle kPlain{false, 80, false};

CheckResult passed(const std::string& id, double points) {
    return check(id, Status::pass, points, points);
}
CheckResult failed(const std::string& id, double most) {
    return check(id, Status::fail, 0, most, "expected 1, got 2", "try " + id);
}

Json resultOf(std::vector<CheckResult> up, std::vector<CheckResult> down = {}) {
    AssignmentResult result;
    result.assignment = "07-camera";
    result.title = "Camera";
    result.buildOk = true;
    const auto statusOf = [](const std::vector<CheckResult>& checks) {
        for (const CheckResult& each : checks)
            if (!each.full())
                return Status::partial;
        return Status::pass;
    };
    const Status first = statusOf(up), second = statusOf(down);
    result.tasks.push_back(task("rotate-up", first, std::move(up)));
    if (!down.empty())
        result.tasks.push_back(task("look-at", second, std::move(down)));
    return Json::parse(toJson(result));
}

Json brokenResult() {
    AssignmentResult result;
    result.assignment = "07-camera";
    result.title = "Camera";
    result.status = "build_error";
    result.diagnostics = {{"Camera.cpp", 17, 5, "error", "expected ';' before 'return'", ""},
                          {"Camera.cpp", 19, 1, "error", "something else", ""}};
    result.tasks.push_back(
        task("rotate-up", Status::buildError,
             {check("a", Status::buildError, 0, 4), check("b", Status::buildError, 0, 6)}));
    return Json::parse(toJson(result));
}

/// "+4 now title of a", for each change.
std::vector<std::string> linesOf(const std::vector<Change>& changes) {
    std::vector<std::string> lines;
    for (const Change& each : changes)
        lines.push_back(fmt::format("{:+g} {}", each.points, each.sentence));
    return lines;
}

TEST(Changes, TheFirstResultChangesNothing) {
    Baseline baseline;
    EXPECT_THAT(baseline.take(resultOf({passed("a", 4), failed("b", 6)})), IsEmpty());
    EXPECT_EQ(baseline.points(), 4);
    EXPECT_THAT(baseline.take(resultOf({passed("a", 4), failed("b", 6)})), IsEmpty());
}

TEST(Changes, EarnedComesBeforeLostAndTheMostFirst) {
    Baseline baseline;
    baseline.take(resultOf({failed("a", 4), failed("b", 6)}, {passed("c", 50)}));
    const auto changes =
        baseline.take(resultOf({passed("a", 4), passed("b", 6)}, {failed("c", 50)}));
    EXPECT_THAT(linesOf(changes),
                ElementsAre("+6 now title of b", "+4 now title of a", "-50 no longer: title of c"));
    EXPECT_EQ(changes.back().message, "expected 1, got 2");
}

TEST(Changes, APictureMayBeNearerOrFurtherOff) {
    Baseline baseline;
    baseline.take(resultOf({check("a", Status::partial, 3, 10)}));
    EXPECT_THAT(linesOf(baseline.take(resultOf({check("a", Status::partial, 5.5, 10)}))),
                ElementsAre("+2.5 nearer: title of a"));
    EXPECT_THAT(linesOf(baseline.take(resultOf({check("a", Status::fail, 0, 10)}))),
                ElementsAre("-5.5 further off: title of a"));
}

TEST(Changes, ManyChecksOfOneTaskTakeFewLines) {
    Baseline baseline;
    std::vector<CheckResult> before, after;
    for (const char* id : {"a", "b", "c", "d", "e"}) {
        before.push_back(failed(id, 2));
        after.push_back(passed(id, 2));
    }
    baseline.take(resultOf(before));
    EXPECT_THAT(
        linesOf(baseline.take(resultOf(after))),
        ElementsAre("+2 now title of a", "+2 now title of b", "+6 3 more checks of rotate-up"));
}

TEST(Changes, WhatDoesNotCompileIsComparedWithNothing) {
    Baseline baseline;
    baseline.take(resultOf({passed("a", 4), failed("b", 6)}));
    EXPECT_THAT(baseline.take(brokenResult()), IsEmpty());
    EXPECT_EQ(baseline.points(), 4) << "it keeps what it had";
    EXPECT_THAT(linesOf(baseline.take(resultOf({passed("a", 4), passed("b", 6)}))),
                ElementsAre("+6 now title of b"));
}

TEST(Changes, AShaderThatDoesNotCompileLosesNothingEither) {
    Baseline baseline;
    baseline.take(resultOf({passed("a", 4)}, {passed("b", 6)}));
    const Json broken = resultOf({passed("a", 4)}, {check("b", Status::buildError, 0, 6)});
    EXPECT_TRUE(doesNotCompile(broken));
    EXPECT_THAT(baseline.take(broken), IsEmpty());
    EXPECT_THAT(baseline.take(resultOf({passed("a", 4)}, {passed("b", 6)})), IsEmpty());
}

TEST(Changes, TheFirstLostCheckIsOneThatCanBeMended) {
    EXPECT_EQ(firstLost(resultOf({passed("a", 1)})), nullptr);
    const Json result = resultOf({passed("a", 1), check("b", Status::skipped, 0, 1)},
                                 {failed("c", 1), failed("d", 1)});
    EXPECT_EQ(firstLost(result)->at("id"), "c");
    EXPECT_EQ(firstLost(resultOf({check("b", Status::skipped, 0, 1)}))->at("id"), "b");
}

TEST(Changes, TheNextTaskIsCyclic) {
    const Json both = resultOf({failed("a", 1)}, {failed("b", 1)});
    EXPECT_EQ(nextTask(both, "")->at("id"), "rotate-up");
    EXPECT_EQ(nextTask(both, "rotate-up")->at("id"), "look-at");
    EXPECT_EQ(nextTask(both, "look-at")->at("id"), "rotate-up");
    EXPECT_EQ(nextTask(resultOf({passed("a", 1)}, {failed("b", 1)}), "look-at")->at("id"),
              "look-at");
    EXPECT_EQ(nextTask(resultOf({passed("a", 1)}), ""), nullptr);
}

TEST(WatchText, AVerdictSaysWhatChangedAndWhatIsNext) {
    Baseline baseline;
    baseline.take(resultOf({failed("a", 4), failed("b", 6)}));
    const Json now = resultOf({failed("a", 4), passed("b", 6)});
    const auto changes = baseline.take(now);
    const std::string text = verdictText(now, changes, baseline, kPlain);
    EXPECT_THAT(text, HasSubstr("07-camera  Camera"));
    EXPECT_THAT(text, HasSubstr("6 / 10\n  +6: now title of b\n"));
    EXPECT_THAT(text, HasSubstr("✗ rotate-up: title of a: expected 1, got 2"));
    EXPECT_THAT(verdictText(now, {}, baseline, kPlain), HasSubstr("No points earned or lost."));
}

TEST(WatchText, FullMarksAreSaid) {
    const Json result = resultOf({passed("a", 4)});
    EXPECT_THAT(verdictText(result, {}, {}, kPlain), HasSubstr("Everything is done"));
    EXPECT_THAT(hintText(result, kPlain), HasSubstr("no hint"));
}

TEST(WatchText, OfABuildErrorTheFirstWithItsHint) {
    Baseline baseline;
    baseline.take(resultOf({passed("a", 4), failed("b", 6)}));
    const std::string text = verdictText(brokenResult(), {}, baseline, kPlain);
    EXPECT_THAT(text, HasSubstr("does not compile"));
    EXPECT_THAT(text, HasSubstr("Camera.cpp:17:5: expected ';'"));
    EXPECT_THAT(text, HasSubstr("hint: a semicolon"));
    EXPECT_THAT(text, HasSubstr("and 1 more"));
    EXPECT_THAT(text, Not(HasSubstr("something else")));
    EXPECT_THAT(text, HasSubstr("it stood at 4 / 10"));
    EXPECT_THAT(hintText(brokenResult(), kPlain), HasSubstr("a semicolon"));
}

TEST(WatchText, TheHintIsThatOfTheFirstLostCheck) {
    EXPECT_THAT(hintText(resultOf({passed("a", 1), failed("b", 1), failed("c", 1)}), kPlain),
                HasSubstr("hint: try b"));
    EXPECT_THAT(hintText(resultOf({check("b", Status::fail, 0, 1, "wrong")}), kPlain),
                HasSubstr("handout"));
}

TEST(WatchText, TheGradersOwnFaultIsNoStudents) {
    AssignmentResult result;
    result.assignment = "07-camera";
    result.title = "Camera";
    result.status = "grader_error";
    result.tasks.push_back(task("rotate-up", Status::graderError,
                                {check("a", Status::graderError, 0, 4, "no OpenGL")}));
    const Json document = Json::parse(toJson(result));
    Baseline baseline;
    baseline.take(resultOf({passed("a", 4)}));
    EXPECT_THAT(baseline.take(document), IsEmpty());
    const std::string text = verdictText(document, {}, baseline, kPlain);
    EXPECT_THAT(text, HasSubstr("The grader itself failed"));
    EXPECT_THAT(text, HasSubstr("no OpenGL"));
}

TEST(WatchText, ATaskSaysWhereItIs) {
    const Json result = resultOf({failed("a", 4)});
    const Json& task = result.at("tasks").at(0);
    const std::string text = taskText(result, task, "assignments/07-camera/Camera.cpp:19", kPlain);
    EXPECT_THAT(text, HasSubstr("assignments/07-camera/README.md: `rotate-up`"));
    EXPECT_THAT(text, HasSubstr("assignments/07-camera/Camera.cpp:19: TODO(rotate-up)"));
    EXPECT_THAT(text, HasSubstr("0 / 4"));
    EXPECT_THAT(text, HasSubstr("✗ title of a: expected 1, got 2"));
    EXPECT_THAT(taskText(result, task, "", kPlain), HasSubstr("in the code: TODO(rotate-up)"));
}

TEST(WatchText, OfATaskWhoseShaderDoesNotCompileTheFirstErrorsAreShown) {
    const Json result = resultOf({check("a", Status::buildError, 0, 4,
                                        "shaders/x.frag does not compile:\n"
                                        "shaders/x.frag:32: error: `oops' undeclared\n")});
    const std::string text = taskText(result, result.at("tasks").at(0), "", kPlain);
    EXPECT_THAT(text, HasSubstr("✗ shaders/x.frag does not compile:\n"));
    EXPECT_THAT(text, HasSubstr("      shaders/x.frag:32: error: `oops' undeclared\n"));
    EXPECT_THAT(text, Not(HasSubstr("title of a")));
}

}  // namespace
