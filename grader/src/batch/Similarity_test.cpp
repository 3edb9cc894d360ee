#include "batch/Similarity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace {

using namespace grader;
using testing::ElementsAre;
using testing::IsEmpty;

const std::string kOriginal = R"(
glm::mat3 rotation(float degrees, const glm::vec3& axis) {
    // Rodrigues
    const float angle = glm::radians(degrees);
    const glm::vec3 a = glm::normalize(axis);
    const float c = std::cos(angle), s = std::sin(angle);
    return c * glm::mat3(1.0f) + (1 - c) * glm::outerProduct(a, a) + s * crossMatrix(a);
}
glm::mat3 other(float degrees) {
    glm::mat3 sum(0.0f);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            sum[i][j] = i == j ? std::cos(degrees) : std::sin(degrees) * float(i - j);
    if (sum[0][0] > 1.0f) { sum[0][0] = 1.0f; }
    return sum;
}
)";

/// The same with other names, numbers, comments and layout.
const std::string kCopied = R"(glm::mat3 rotation(float w,const glm::vec3&u){
const float phi=glm::radians(w); /* mine */ const glm::vec3 n=glm::normalize(u);
const float co=std::cos(phi),si=std::sin(phi);
return co*glm::mat3(2.0f)+(3-co)*glm::outerProduct(n,n)+si*crossMatrix(n);}
glm::mat3 helper(float w){glm::mat3 m(0.5f);for(int p=0;p<4;++p)for(int q=0;q<4;++q)
m[p][q]=p==q?std::cos(w):std::sin(w)*float(p-q);if(m[0][0]>2.0f){m[0][0]=2.0f;}return m;})";

const std::string kOther = R"(
glm::mat3 rotation(float degrees, const glm::vec3& axis) {
    glm::quat q = glm::angleAxis(glm::radians(degrees), axis / glm::length(axis));
    float x = q.x, y = q.y, z = q.z, w = q.w;
    glm::mat3 m;
    m[0] = glm::vec3(1 - 2 * y * y - 2 * z * z, 2 * x * y + 2 * w * z, 2 * x * z - 2 * w * y);
    m[1] = glm::vec3(2 * x * y - 2 * w * z, 1 - 2 * x * x - 2 * z * z, 2 * y * z + 2 * w * x);
    m[2] = glm::vec3(2 * x * z + 2 * w * y, 2 * y * z - 2 * w * x, 1 - 2 * x * x - 2 * y * y);
    return m;
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
    EXPECT_TRUE(std::any_of(one.begin(), one.end(), [&](auto each) { return two.contains(each); }));
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
