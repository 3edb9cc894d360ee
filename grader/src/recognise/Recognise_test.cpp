#include "recognise/Recognise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Error.h"
#include "Fields.h"
#include "testing/Tree.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing_help::whatOf;

Evidence vec3(const std::string& key, double x, double y, double z) {
    return {key, "ok", "vec3", {x, y, z}};
}

/// A task "turn" of which two inputs are asked; two mistakes answer the first one otherwise, and
/// one of them the second one, too.
Signatures known() {
    Signatures signatures;
    signatures.right = {{"a", vec3("a", 1, 2, 3)}, {"b", vec3("b", 4, 5, 6)}};
    signatures.mistakes.push_back({"halved",
                                   "turn",
                                   "You halve it.",
                                   "",
                                   "6.1",
                                   {"turn"},
                                   {{"a", vec3("a", 0.5, 1, 1.5)}},
                                   {}});
    signatures.mistakes.push_back({"thirds",
                                   "turn",
                                   "You take a third.",
                                   "",
                                   "6.2",
                                   {"turn"},
                                   {{"a", vec3("a", 0.5, 1, 1.5)}, {"b", vec3("b", 0, 0, 9)}},
                                   {}});
    return signatures;
}

std::vector<CheckResult> answered(const std::vector<Evidence>& evidence) {
    CheckResult check;
    check.id = "Turn.Once";
    check.task = "turn";
    check.status = Status::fail;
    check.maxPoints = 5;
    check.evidence = evidence;
    return {check};
}

TEST(Recognising, NamesTheMistakeWhoseAnswersTheseAre) {
    const auto said =
        recognise(known(), "turn", answered({vec3("a", 0.5, 1, 1.5), vec3("b", 4, 5, 6)}));
    ASSERT_TRUE(said);
    EXPECT_THAT(said->mistakes, ElementsAre("halved"));
    EXPECT_EQ(said->says, "You halve it.");
    EXPECT_EQ(said->section, "6.1");
}

TEST(Recognising, SaysNothingWhenOneAnswerIsNoKnownMistakes) {
    EXPECT_FALSE(
        recognise(known(), "turn", answered({vec3("a", 0.5, 1, 1.5), vec3("b", 7, 7, 2)})));
}

TEST(Recognising, SaysNothingOfWhatLosesNothing) {
    auto checks = answered({vec3("a", 0.5, 1, 1.5)});
    checks.front().status = Status::pass;
    EXPECT_FALSE(recognise(known(), "turn", checks));
    checks.front().status = Status::notImplemented;
    EXPECT_FALSE(recognise(known(), "turn", checks));
}

TEST(Recognising, SaysNothingOfAnotherTask) {
    EXPECT_FALSE(recognise(known(), "other", answered({vec3("a", 0.5, 1, 1.5)})));
}

TEST(Recognising, TellsTogetherWhatCannotBeToldApart) {
    const auto said = recognise(known(), "turn", answered({vec3("a", 0.5, 1, 1.5)}));
    ASSERT_TRUE(said);
    EXPECT_THAT(said->mistakes, ElementsAre("halved", "thirds"));
    EXPECT_THAT(said->says, HasSubstr("You halve it. Or: You take a third."));
    EXPECT_EQ(said->section, "6.1, 6.2");
}

TEST(Recognising, SaysWhatSeveralHaveInCommon) {
    Signatures signatures = known();
    for (Signature& each : signatures.mistakes)
        each.common = "It is too small.";
    const auto said = recognise(signatures, "turn", answered({vec3("a", 0.5, 1, 1.5)}));
    ASSERT_TRUE(said);
    EXPECT_EQ(said->says, "It is too small.");
}

TEST(Recognising, TriesTheUsualSlipsWhereNoMistakeFits) {
    const auto said =
        recognise(known(), "turn", answered({vec3("a", -1, -2, -3), vec3("b", -4, -5, -6)}));
    ASSERT_TRUE(said);
    EXPECT_THAT(said->mistakes, IsEmpty());
    EXPECT_THAT(said->says, HasSubstr("opposite sign"));
}

TEST(Recognising, KnowsAFrameThatLooksLikeTheMistakes) {
    const auto flat = [](std::uint8_t red) {
        Picture picture{40, 40, std::vector<std::uint8_t>(4 * 40 * 40, 255), {}};
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
            picture.rgba[i] = red;
        return picture;
    };
    Signatures signatures = known();
    signatures.mistakes.front().answers.clear();
    signatures.mistakes.front().frames["front"] = thumbnailOf(flat(100));
    CheckResult frame;
    frame.id = "front";
    frame.kind = "frame";
    frame.task = "turn";
    frame.status = Status::fail;
    frame.pictures.emplace();
    frame.pictures->reference = flat(200);
    frame.pictures->submission = flat(101);
    const auto said = recognise(signatures, "turn", {frame});
    ASSERT_TRUE(said);
    EXPECT_THAT(said->mistakes, ElementsAre("halved"));
    frame.pictures->submission = flat(150);
    EXPECT_FALSE(recognise(signatures, "turn", {frame}));
}

TEST(Signatures, AnswersAgreeButForRounding) {
    EXPECT_TRUE(agree(vec3("a", 1, 2, 3), vec3("a", 1.0005, 2, 3)));
    EXPECT_FALSE(agree(vec3("a", 1, 2, 3), vec3("a", 1.01, 2, 3)));
    EXPECT_FALSE(agree(vec3("a", 1, 2, 3), {"a", "died", "", {}}));
    EXPECT_FALSE(agree(vec3("a", 1, 2, 3), {"a", "ok", "vec2", {1, 2}}));
    Evidence shares{"a", "ok", "shares", std::vector<double>(200, 1)}, other = shares;
    other.numbers[0] = other.numbers[1] = 0;
    EXPECT_TRUE(agree(shares, other));
    other.numbers[2] = 0;
    EXPECT_FALSE(agree(shares, other));
}

TEST(Signatures, ComeBackFromTheFileAsTheyWere) {
    Signatures signatures = known();
    std::vector<double> bits(203, 0);
    bits[0] = bits[9] = bits[202] = 1;
    signatures.right["s"] = {"s", "ok", "shares", bits};
    signatures.mistakes.front().common = "Both are too small.";
    signatures.mistakes.front().frames["front"] = {2, 1, {1, 2, 3, 4, 5, 6}};
    const WorkFolder folder;
    const fs::path file = folder.path() / "signatures.cbor";
    signatures.save(file);
    const Signatures back = Signatures::load(file);
    EXPECT_THAT(differing(signatures, back), IsEmpty());
    EXPECT_EQ(back.right.at("s").numbers, bits);
    EXPECT_EQ(back.mistakes.front().common, "Both are too small.");
    EXPECT_EQ(back.mistakes.front().frames.at("front").rgb[5], 6);
}

TEST(Signatures, NameTheMistakesThatChanged) {
    Signatures changed = known();
    changed.mistakes.back().says = "You take a quarter.";
    EXPECT_THAT(differing(known(), changed), ElementsAre("thirds"));
    changed.mistakes.pop_back();
    EXPECT_THAT(differing(known(), changed), ElementsAre("thirds"));
    changed.right["b"].numbers[0] = 0;
    EXPECT_THAT(differing(known(), changed), ElementsAre("the solution", "thirds"));
}

TEST(Signatures, AFileThatIsNoneIsNamed) {
    const WorkFolder folder;
    const fs::path file = folder.path() / "signatures.cbor";
    writeFile(file, "no such thing");
    const auto complaint = [&] { return whatOf<Error>([&] { Signatures::load(file); }); };
    EXPECT_THAT(complaint(), HasSubstr(file.string()));
    EXPECT_THAT(complaint(), HasSubstr("run ./grade update-references"));
    Json damaged = {{"format", 3}, {"right", Json::array()}, {"mistakes", Json::array()}};
    damaged["right"].push_back(
        Json::array({"s", "ok", "shares", 3, Json::binary(std::vector<std::uint8_t>(5))}));
    const auto bytes = Json::to_cbor(damaged);
    writeFile(file, std::string(bytes.begin(), bytes.end()));
    EXPECT_THAT(complaint(), HasSubstr(file.string()));
    EXPECT_THAT(complaint(), HasSubstr("(3 shares in 5 bytes): run ./grade update-references"));
    damaged["format"] = 2;
    const auto older = Json::to_cbor(damaged);
    writeFile(file, std::string(older.begin(), older.end()));
    EXPECT_THAT(complaint(), HasSubstr("(expected format 3, found 2): run ./grade"));
}

}  // namespace
