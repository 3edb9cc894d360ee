#include "batch/Similarity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "Tokens.h"

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::IsEmpty;

const std::string kOriginal = R"(
float spiral(float turns, const glm::vec2& centre) {
    // Archimedes
    const float full = turns * 6.2831853f;
    const glm::vec2 from = centre / glm::length(centre);
    const float near = std::exp(-full), far = std::sqrt(full);
    return near * from.x + (1 - near) * glm::dot(from, centre) + far * wobble(from);
}
float other(float turns) {
    float sum(0.0f);
    for (int i = 0; i < 3; ++i)
        while (sum < turns)
            sum += i == 2 ? std::exp(turns) : std::sqrt(turns) * float(i + 7);
    if (sum > 1.0f) { sum = 1.0f - sum * sum; }
    return sum;
}
)";

/// The same with other names, numbers, comments and layout.
const std::string kCopied = R"(float spiral(float w,const glm::vec2&u){
const float phi=w*3.1415f; /* mine */ const glm::vec2 n=u/glm::length(u);
const float co=std::exp(-phi),si=std::sqrt(phi);
return co*n.x+(3-co)*glm::dot(n,u)+si*wobble(n);}
float helper(float w){float m(0.5f);for(int p=0;p<4;++p)while(m<w)
m+=p==1?std::exp(w):std::sqrt(w)*float(p+5);if(m>2.0f){m=2.0f-m*m;}return m;})";

const std::string kOther = R"(
float spiral(float turns, const glm::vec2& centre) {
    glm::vec4 row = glm::fract(glm::vec4(turns, turns / 2, turns / 3, centre.x / centre.y));
    float x = row.x, y = row.y, z = row.z, w = row.w;
    float sum = 0;
    sum += x < y ? glm::mix(x, z, 0.5f) - 2 * w * w : glm::step(z, 2 * x * y) + w;
    sum += y < z ? glm::mix(y, w, 0.2f) - 2 * x * w : glm::step(w, 2 * y * z) + x;
    sum += z < w ? glm::mix(z, x, 0.3f) - 2 * x * y : glm::step(x, 2 * z * w) + y;
    return sum;
}
)";

Print printOf(const std::string& name, const std::string& text) {
    return {name, fingerprintsOf(text), wordsOf(text)};
}

TEST(Tokens, NamesNumbersAndCommentsMakeNoDifference) {
    EXPECT_THAT(tokensOf("if (a_1 == 0x1F) /* if */ return \"a\\\"b\"; // end"),
                ElementsAre("if", "(", "NAME", "=", "=", "NUMBER", ")", "return", "STRING", ";"));
    EXPECT_EQ(tokensOf(kOriginal), tokensOf(kCopied));
    EXPECT_THAT(tokensOf("/* never closed"), IsEmpty());
    EXPECT_THAT(tokensOf("\"never closed"), ElementsAre("STRING"));
    EXPECT_THAT(tokensOf("/"), ElementsAre("/"));
}

TEST(Fingerprints, OfACopyAreTheSameAndOfOtherCodeOthers) {
    EXPECT_EQ(fingerprintsOf(kOriginal), fingerprintsOf(kCopied));
    EXPECT_GT(fingerprintsOf(kOriginal).size(), 10u);
    const auto likenesses = nearlyIdentical(
        {printOf("ann", kOriginal), printOf("bob", kOther), printOf("cy", kCopied)});
    ASSERT_EQ(likenesses.size(), 1u);
    EXPECT_EQ(likenesses[0].first, "ann");
    EXPECT_EQ(likenesses[0].second, "cy");
    EXPECT_EQ(likenesses[0].share, 1);
    EXPECT_FALSE(likenesses[0].identical);
}

TEST(Fingerprints, AnythingSharedThatIsLongEnoughIsFound) {
    const std::string shared = "a = b * (c + d[1]) - e / f; g = h * i + j;";
    EXPECT_GE(tokensOf(shared).size(), kSureTokens);
    const auto one = fingerprintsOf("int x = 3; if (x) y(); " + shared + " return x;");
    const auto two = fingerprintsOf("while (z < 4) { ++z; q(z, z); } " + shared + " break;");
    EXPECT_LT(without(one, two).size(), one.size());
    EXPECT_EQ(joined(one, two).size(), without(one, two).size() + two.size());
}

TEST(Fingerprints, AreThoseOfEarlierYears) {
    EXPECT_THAT(fingerprintsOf(std::string(kSureTokens, ';')), ElementsAre(17313449628622483053u));
}

TEST(NearlyIdentical, WhatTheWholeClassWritesIsNotCounted) {
    std::vector<Print> prints;
    for (int i = 0; i < 20; ++i)
        prints.push_back(
            {fmt::format("s{:02}", i), fingerprintsOf(kOriginal), fmt::format("text {}", i)});
    EXPECT_THAT(nearlyIdentical(prints), IsEmpty());
    prints[3].exact = prints[7].exact;
    const auto likenesses = nearlyIdentical(prints);
    ASSERT_EQ(likenesses.size(), 1u) << "the very same text is said all the same";
    EXPECT_TRUE(likenesses[0].identical);
}

TEST(NearlyIdentical, OfATextTooShortNothingIsSaid) {
    EXPECT_THAT(nearlyIdentical({printOf("a", "return 1;"), printOf("b", "return 1;")}), IsEmpty());
}

}  // namespace
