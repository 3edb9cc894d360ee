#include "report/Words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/Results.h"

namespace {

using namespace grader;
using testing::HasSubstr;
using testing_help::check;
using testing_help::sampleResult;
using testing_help::task;

AssignmentResult withStatuses(const std::vector<Status>& statuses) {
    AssignmentResult result = sampleResult();
    result.tasks.clear();
    for (std::size_t i = 0; i < statuses.size(); ++i)
        result.tasks.push_back(
            task("t" + std::to_string(i), statuses[i], {check("T.A", statuses[i], 0, 10)}));
    return result;
}

TEST(ShowPoints, IsNeverRoundedUp) {
    EXPECT_EQ(showPoints(0), "0");
    EXPECT_EQ(showPoints(100), "100");
    EXPECT_EQ(showPoints(5.5), "5.5");
    EXPECT_EQ(showPoints(99.99), "99.9");
    EXPECT_EQ(showPoints(9.96), "9.9");
    EXPECT_EQ(showPoints(5.94), "5.9");
    EXPECT_EQ(showPoints(0.04), "0.04") << "a little is not nothing";
    EXPECT_EQ(showPoints(1e-9), "0");
    EXPECT_EQ(showPoints(0.3), "0.3") << "though 0.3 * 10 is not 3";
    EXPECT_EQ(showPoints(100.0 / 3 + 100.0 / 3 + 100.0 / 3), "100") << "but noise is not a loss";
    EXPECT_EQ(showPoints(0.1 + 0.1 + 0.1 + 0.1 + 0.1 + 0.1 + 0.1 + 0.1 + 0.1 + 0.1), "1");
}

TEST(WhatNext, SaysWhatIsDoneAndWhatToDo) {
    using enum Status;
    EXPECT_EQ(whatNext(withStatuses({pass, pass})),
              "Everything is done: all 2 tasks have full marks.");
    EXPECT_EQ(whatNext(withStatuses({pass, fail, fail})),
              "1 of 3 tasks is done; go on with t1 (Task t1), which has 0 of 10 points.");
    EXPECT_THAT(whatNext(withStatuses({pass, pass, fail})), HasSubstr("2 of 3 tasks are done;"));
    EXPECT_THAT(whatNext(withStatuses({partial, fail})),
                HasSubstr("No task is done yet; go on with t0"));
    EXPECT_EQ(whatNext(withStatuses({notImplemented, notImplemented})),
              "Nothing is done yet: begin with t0 (Task t0).");
}

TEST(WhatNext, DoesNotSendToATaskThatWaitsForAnother) {
    using enum Status;
    EXPECT_THAT(whatNext(withStatuses({skipped, partial})), HasSubstr("go on with t1"));
    EXPECT_THAT(whatNext(withStatuses({pass, skipped})), HasSubstr("go on with t1"));
}

TEST(WhatNext, WhereNothingCouldBeChecked) {
    AssignmentResult result = withStatuses({Status::buildError});
    result.status = "build_error";
    EXPECT_THAT(whatNext(result), HasSubstr("mend the first error"));
    EXPECT_THAT(whatNext(withStatuses({Status::graderError})), HasSubstr("not your mistake"));
}

TEST(Quoted, HasTheCaretBelowTheColumn) {
    const auto source = quoted({"a.cpp", 1, 5, "error", "", "int x\x1b;"}, 40);
    EXPECT_EQ(source.line, "int x ;");
    EXPECT_EQ(source.caret, "    ^");
}

TEST(Quoted, HasNoCaretWhereTheColumnIsUnknownOrForged) {
    for (const int column : {0, 8, 999999999})
        EXPECT_EQ(quoted({"a.cpp", 1, column, "error", "", "int x;"}, 40).caret, "") << column;
    EXPECT_EQ(quoted({"a.cpp", 1, 7, "error", "", "int x;"}, 40).caret, "      ^") << "its end";
    EXPECT_EQ(quoted({"a.cpp", 1, 1, "error", "", ""}, 40).caret, "");
}

TEST(Quoted, ShowsWhatIsAroundTheCaretOfALongLine) {
    const std::string line = std::string(100, 'a') + "X" + std::string(100, 'b');
    const auto source = quoted({"a.cpp", 1, 101, "error", "", line}, 20);
    EXPECT_EQ(source.line.size(), 20u);
    EXPECT_EQ(source.line.at(source.caret.size() - 1), 'X');
    const auto end = quoted({"a.cpp", 1, 202, "error", "", line}, 20);
    EXPECT_EQ(end.line, std::string(19, 'b'));
    EXPECT_EQ(end.caret, std::string(19, ' ') + "^");
    EXPECT_EQ(quoted({"a.cpp", 1, 3, "error", "", line}, 20).caret, "  ^");
}

}  // namespace
