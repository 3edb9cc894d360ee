#include "batch/Earlier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "batch/Overview.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::HasSubstr;
using testing_help::Tree;
using testing_help::whatOf;

Print printOf(const std::string& name, std::uint64_t from) {
    Print print{name, {}, std::to_string(from)};
    for (std::uint64_t each = from; each < from + 20; ++each)
        print.own.push_back(each);
    return print;
}

/// A batch of last year, and one of today; the same number, the same work.
class EarlierTest : public testing::Test {
protected:
    EarlierTest() {
        tree_.write("old/results.json", R"({"format": 1, "assignment": "06-rotation", "seed": 1})");
        for (const auto& [name, from] : {std::pair("ann", 100), {"bob", 100}, {"cy", 200}})
            Ledger(tree_ / "old").keepPrint(printOf(name, std::uint64_t(from)));
        Ledger(tree_ / "new").keepPrint(printOf("ann", 200));
        Ledger(tree_ / "new").keepPrint(printOf("dee", 300));
    }
    std::string refusal(const std::string& folder) const {
        return whatOf<Error>([&] { earlierPrints({(tree_ / folder).string()}, "06-rotation"); });
    }
    Tree tree_;
};

TEST_F(EarlierTest, OnlyPairsWithSomebodyOfTodayAreSaid) {
    const std::string old = (tree_ / "old").string();
    std::vector<Mark> marks(2);
    marks[0].submission = "ann";
    marks[1].submission = "dee";
    const Ledger ledger(tree_ / "new");
    EXPECT_TRUE(likenessesAmong(ledger, marks).empty());
    const auto found =
        likenessesAmong(ledger, marks, earlierPrints({old, old + "/"}, "06-rotation"));
    ASSERT_EQ(found.size(), 1u)
        << "ann and bob of last year are alike, and none of today's business";
    EXPECT_EQ(found[0].first, "ann");
    EXPECT_EQ(found[0].second, old + "/cy");
    EXPECT_TRUE(found[0].identical);
}

TEST_F(EarlierTest, RefusesWhatIsNoBatchOfTheAssignment) {
    EXPECT_THAT(refusal("new"), HasSubstr("it has no results.json"));
    tree_.write("other/results.json", "{}");
    EXPECT_THAT(refusal("other"), HasSubstr("other/results.json is not as ./grade batch wrote it"));
    tree_.write("other/results.json", R"({"format": 1, "assignment": "07-camera", "seed": 1})");
    EXPECT_THAT(refusal("other"), HasSubstr("holds results of 07-camera"));
    tree_.write("empty/results.json", R"({"format": 1, "assignment": "06-rotation", "seed": 1})");
    EXPECT_THAT(refusal("empty"), HasSubstr("no submission to compare with"));
}

}  // namespace
