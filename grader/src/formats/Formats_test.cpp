#include "formats/Formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing_help::Tree;

Scored scored(const fs::path& report = {}) {
    Scored one{"ann", 54.6, 100, {{"rotation", 42}}, {"2 days late"}, Json(), report};
    one.result = Json::parse(R"({
        "assignment": "06-rotation",
        "build": {"ok": true, "diagnostics": []},
        "tasks": [{"id": "rotation", "title": "Turn", "points": 40.4, "checks": [
            {"id": "Rotation.Turns", "title": "turns <x>", "status": "pass", "points": 40.4,
             "max_points": 40.4, "message": "", "hint": ""},
            {"id": "Rotation.Drawn", "title": "drawn axes", "status": "fail", "points": 0,
             "max_points": 4, "message": "wrong", "hint": "", "visibility": "after_due_date"},
            {"id": "turned", "title": "a frame", "status": "fail", "points": 0, "max_points": 5.5,
             "message": "too & dark", "hint": "light it",
             "images": {"submission": "06-rotation/turned.png",
                        "reference": "06-rotation/turned.reference.png"}}],
            "recognised": {"mistakes": ["lamp"], "says": "no lamp is lit", "section": "6.3"}},
            {"id": "spot", "title": "Spot", "points": 0, "checks": [
            {"id": "spot", "title": "a person looks", "status": "pending", "points": 0,
             "max_points": 10, "message": "", "hint": ""}]}],
        "notices": ["Scene.cpp is missing"], "ignored_files": ["a.txt"], "environment": {"sandbox": "plain"}})");
    return one;
}

Scored broken() {
    Scored one{"bob", 0, 100, {}, {}, Json(), {}};
    one.result = Json::parse(R"({"assignment": "06-rotation", "tasks": [], "build": {"ok": false,
        "diagnostics": [{"file": "rotation.cpp", "line": 3, "severity": "error",
                         "message": "expected ';'"}]}})");
    return one;
}

TEST(Gradescope, HasATestForEachCheck) {
    const Json json = Json::parse(gradescopeResult(scored()));
    EXPECT_EQ(json.at("score"), 54.6) << "lateness and decisions are in it";
    EXPECT_EQ(json.at("output"),
              "2 days late\nScene.cpp is missing\nNot taken: a.txt\nSandbox: plain");
    ASSERT_EQ(json.at("tests").size(), 3u) << "a check that waits for a person has not failed";
    const Json& failed = json.at("tests").at(2);
    EXPECT_EQ(failed.at("name"), "Turn: a frame");
    EXPECT_EQ(failed.at("status"), "failed");
    EXPECT_EQ(failed.at("max_score"), 5.5);
    EXPECT_EQ(failed.at("output"), "too & dark\nno lamp is lit (section 6.3)\nHint: light it");
    EXPECT_EQ(failed.at("output_format"), "text") << "there is no picture";
    EXPECT_EQ(json.at("tests").at(0).at("status"), "passed");
    EXPECT_EQ(Json::parse(gradescopeResult(broken())).at("output"), "rotation.cpp:3: expected ';'");
}

TEST(Gradescope, ShowsAChecksWhenTheManifestSays) {
    const Json json = Json::parse(gradescopeResult(scored()));
    EXPECT_EQ(json.at("tests").at(0).at("visibility"), "visible");
    EXPECT_EQ(json.at("tests").at(1).at("visibility"), "after_due_date");
    EXPECT_EQ(json.at("tests").at(1).at("output"), "wrong")
        << "the recognised mistake stands where the student sees it";
    EXPECT_EQ(json.at("stdout_visibility"), "hidden");
}

TEST(Gradescope, ShowsPicturesAsFarAsThereIsRoom) {
    const Tree tree;
    tree.write("06-rotation/turned.png", "PNG");
    tree.write("06-rotation/turned.reference.png", std::string(900 * 1000, 'x'));
    const std::string text = gradescopeResult(scored(tree.path()));
    const Json json = Json::parse(text);
    const Json& failed = json.at("tests").at(2);
    EXPECT_EQ(failed.at("output_format"), "html");
    EXPECT_THAT(failed.at("output"), HasSubstr("<p>too &amp; dark</p><p>no lamp"));
    EXPECT_THAT(failed.at("output"), HasSubstr("src=\"data:image/png;base64,UE5H\""));
    EXPECT_THAT(failed.at("output"), Not(HasSubstr("right")));
    EXPECT_LT(text.size(), 1000u * 1000u);
}

TEST(Gradescope, AFaultIsNoMark) {
    const Json json = Json::parse(gradescopeFault());
    EXPECT_FALSE(json.contains("score"));
    EXPECT_TRUE(json.at("tests").empty());
    EXPECT_THAT(json.at("output"), HasSubstr("not your mistake"));
}

/// As much text as a document may hold, in letters of four bytes.
Scored talkative() {
    std::string text;
    for (int i = 0; i < 100 * 1000; ++i)
        text += "\xF0\x9F\x90\xB0";
    Scored one = scored();
    Json& checks = one.result["tasks"][0]["checks"];
    for (Json& check : checks)
        check["message"] = text;
    for (int i = 0; i < 200; ++i)
        checks.push_back(checks[2]);
    one.result["notices"] = {text};
    return one;
}

TEST(Gradescope, TextsAreCutWhereTheyWouldNotFit) {
    const std::string text = gradescopeResult(talkative());
    EXPECT_LT(text.size(), 1000u * 1000u);
    EXPECT_EQ(Json::parse(text).at("tests").size(), 203u);
}

TEST(PrairieLearn, ScoresFromNoughtToOneWithPicturesThatFit) {
    const Tree tree;
    tree.write("06-rotation/turned.png", "PNG");
    tree.write("06-rotation/turned.reference.png", "RIGHT");
    const Json json = Json::parse(prairieLearnResult(scored(tree.path())));
    EXPECT_EQ(json.at("gradable"), true);
    EXPECT_NEAR(json.at("score").get<double>(), 0.546, 1e-12);
    const Json& images = json.at("tests").at(1).at("images");
    ASSERT_EQ(images.size(), 2u);
    EXPECT_EQ(images.at(0).at("label"), "yours");
    EXPECT_EQ(images.at(0).at("url"), "data:image/png;base64,UE5H");
    tree.write("06-rotation/turned.png", std::string(900 * 1000, 'x'));
    const std::string large = prairieLearnResult(scored(tree.path()));
    EXPECT_EQ(Json::parse(large).at("tests").at(1).at("images").size(), 1u)
        << "a megabyte is the limit";
    EXPECT_LT(large.size(), 1000u * 1000u);
    EXPECT_LT(prairieLearnResult(talkative()).size(), 1000u * 1000u);
}

TEST(PrairieLearn, HasNoCheckThatItsStudentMayNotSee) {
    const std::string text = prairieLearnResult(scored());
    EXPECT_EQ(Json::parse(text).at("tests").size(), 2u);
    EXPECT_THAT(text, Not(HasSubstr("drawn axes")));
    EXPECT_THAT(text, HasSubstr("Checks that are not shown: 1"));
}

TEST(PrairieLearn, WhatDoesNotCompileOrWasNotGradedTakesNoAttempt) {
    const Json json = Json::parse(prairieLearnResult(broken()));
    EXPECT_EQ(json.at("gradable"), false);
    EXPECT_EQ(json.at("format_errors").at(0), "rotation.cpp:3: expected ';'");
    Scored decided = broken();
    decided.points = 10;
    EXPECT_EQ(Json::parse(prairieLearnResult(decided)).at("gradable"), true)
        << "a person gave points";
    const Json fault = Json::parse(prairieLearnFault());
    EXPECT_EQ(fault.at("gradable"), false);
    EXPECT_FALSE(fault.contains("score"));
    EXPECT_THAT(fault.at("message"), HasSubstr("not your mistake"));
}

TEST(Classroom50, HasWholePoints) {
    const Json json =
        Json::parse(classroom50Result(scored(), {"graphics", "2026-11-01T00:00:00Z"}));
    EXPECT_EQ(json.at("schema"), "classroom50/result/v1");
    EXPECT_EQ(json.at("score"), 55);
    EXPECT_TRUE(json.at("score").is_number_integer());
    EXPECT_EQ(json.at("tests").at(1).at("max-score"), 6);
    EXPECT_EQ(json.at("owner"), "ann");
}

TEST(Autolab, IsOneLineOfPointsByTask) {
    EXPECT_EQ(autolabLine(scored()), "{\"scores\":{\"rotation\":42.0}}\n") << "as decided";
    EXPECT_EQ(autolabLine(broken()), "{\"scores\":{}}\n");
    EXPECT_THAT(autolabFault(), AllOf(HasSubstr("not your mistake"), Not(HasSubstr("scores"))));
}

TEST(JUnit, EscapesAndCounts) {
    const std::string xml = junitXml("06-rotation", {scored(), broken()});
    EXPECT_THAT(xml, HasSubstr("<testsuites name=\"06-rotation\" tests=\"4\" failures=\"3\">"));
    EXPECT_THAT(xml, HasSubstr("<testsuite name=\"ann\" tests=\"3\" failures=\"2\""));
    EXPECT_THAT(xml, HasSubstr("<testcase name=\"turned\" classname=\"rotation\"><failure "
                               "message=\"too &amp; dark\">too &amp; dark\nno lamp is lit (section "
                               "6.3)\nHint: light it"));
    EXPECT_THAT(xml, HasSubstr("rotation.cpp:3"));
    EXPECT_THAT(xml, Not(HasSubstr("<x>")));
}

}  // namespace
