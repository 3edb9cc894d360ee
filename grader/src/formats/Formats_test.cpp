#include "formats/Formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/Tree.h"

namespace {

using namespace grader;
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
            {"id": "turned", "title": "a frame", "status": "fail", "points": 0, "max_points": 5.5,
             "message": "too & dark", "hint": "light it",
             "images": {"submission": "06-rotation/turned.png"}}]}]})");
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
    EXPECT_EQ(json.at("output"), "2 days late");
    const Json& failed = json.at("tests").at(1);
    EXPECT_EQ(failed.at("name"), "Turn: a frame");
    EXPECT_EQ(failed.at("status"), "failed");
    EXPECT_EQ(failed.at("max_score"), 5.5);
    EXPECT_EQ(failed.at("output"), "too & dark\nHint: light it");
    EXPECT_EQ(json.at("tests").at(0).at("status"), "passed");
    EXPECT_EQ(Json::parse(gradescopeResult(broken())).at("output"), "rotation.cpp:3: expected ';'");
}

TEST(PrairieLearn, ScoresFromNoughtToOneWithPicturesThatFit) {
    const Tree tree;
    tree.write("06-rotation/turned.png", "PNG");
    const Json json = Json::parse(prairieLearnResult(scored(tree.path())));
    EXPECT_EQ(json.at("gradable"), true);
    EXPECT_NEAR(json.at("score").get<double>(), 0.546, 1e-12);
    ASSERT_EQ(json.at("images").size(), 1u);
    EXPECT_EQ(json.at("images").at(0).at("url"), "data:image/png;base64,UE5H");
    tree.write("06-rotation/turned.png", std::string(900 * 1000, 'x'));
    const std::string large = prairieLearnResult(scored(tree.path()));
    EXPECT_TRUE(Json::parse(large).at("images").empty()) << "a megabyte is the limit";
    EXPECT_LT(large.size(), 1000u * 1000u);
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
}

TEST(JUnit, EscapesAndCounts) {
    const std::string xml = junitXml("06-rotation", {scored(), broken()});
    EXPECT_THAT(xml, HasSubstr("<testsuites name=\"06-rotation\" tests=\"3\" failures=\"2\">"));
    EXPECT_THAT(xml, HasSubstr("<testsuite name=\"ann\" tests=\"2\" failures=\"1\""));
    EXPECT_THAT(xml, HasSubstr("<testcase name=\"turned\" classname=\"rotation\"><failure "
                               "message=\"too &amp; dark\">too &amp; dark\nHint: light it"));
    EXPECT_THAT(xml, HasSubstr("rotation.cpp:3"));
    EXPECT_THAT(xml, Not(HasSubstr("<x>")));
}

}  // namespace
