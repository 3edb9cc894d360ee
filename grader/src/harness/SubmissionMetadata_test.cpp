#include "harness/SubmissionMetadata.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Fields.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::IsEmpty;

/// As Gradescope documents it, handed in 3 h 20 min late.
Json metadata() {
    return Json::parse(R"({
        "id": 123456, "created_at": "2018-08-01T02:20:00.365935-07:00",
        "assignment": {"due_date": "2018-07-31T23:00:00.000000-07:00", "late_due_date": null,
                       "title": "Rotation", "total_points": "100.0"},
        "submission_method": "upload",
        "users": [{"email": "student@example.com", "id": 1, "name": "A Student"}],
        "previous_submissions": [
            {"submission_time": "2018-07-30T10:00:00.000000-07:00", "score": 70, "results": {}},
            {"submission_time": "2018-07-29T10:00:00.000000-07:00", "score": 10, "results": {}}]})");
}

std::vector<std::string> remarksOf(const Json& json, double points = 80, bool tellPoints = true) {
    return remarksFrom(json.dump(), points, tellPoints);
}

constexpr const char* kLate =
    "Handed in 3 h 20 min after the due date. What that costs is not in these points.";

TEST(SubmissionMetadata, TellsHowLateItIsAndWhatTheNewestSubmissionBeforeHad) {
    EXPECT_THAT(remarksOf(metadata()),
                ElementsAre(kLate, "80 points; the submission before this one had 70."));
}

TEST(SubmissionMetadata, OfPointsThatAreNotShownYetNothingIsTold) {
    EXPECT_THAT(remarksOf(metadata(), 80, false), ElementsAre(kLate));
}

TEST(SubmissionMetadata, SixtyMinutesAreAnHour) {
    Json json = metadata();
    json["created_at"] = "2018-08-01T00:59:30-07:00";
    EXPECT_THAT(remarksOf(json, 80, false),
                ElementsAre("Handed in 2 h 0 min after the due date. What that costs is not in "
                            "these points."));
}

TEST(SubmissionMetadata, TellsWhenTheLateDueDateIsOver) {
    Json json = metadata();
    json["assignment"]["late_due_date"] = "2018-08-01T07:00:00Z";
    json["created_at"] = "2018-08-02T09:30:00Z";
    EXPECT_THAT(remarksOf(json, 70),
                ElementsAre("Handed in 1 d 3 h after the due date, and after the late due date. "
                            "What that costs is not in these points."));
}

TEST(SubmissionMetadata, InTimeAndTheFirstNothingIsTold) {
    Json json = metadata();
    json["created_at"] = "2018-07-31T22:59:59-07:00";
    json["previous_submissions"] = Json::array();
    EXPECT_THAT(remarksOf(json), IsEmpty());
}

TEST(SubmissionMetadata, WhatIsNotAsExpectedIsPassedOver) {
    for (const char* text : {"", "no JSON", "[]", "{}", "null", R"({"assignment": 3})",
                             R"({"created_at": "yesterday", "assignment": {"due_date": 5}})",
                             R"({"previous_submissions": {"score": 3}})",
                             R"({"previous_submissions": [7, {"score": "many"}, {"score": 4}]})"})
        EXPECT_THAT(remarksFrom(text, 80, true), IsEmpty()) << text;
    EXPECT_THAT(remarksFrom("{\"created_at\": \"\xFF\"}", 80, true), IsEmpty());
}

}  // namespace
