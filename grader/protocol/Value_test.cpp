#include "protocol/Value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace {

using protocol::Bytes;
using protocol::decode;
using protocol::encode;
using protocol::ProtocolError;
using testing::ElementsAre;
using testing::HasSubstr;

template <class T>
std::string refusal(const Bytes& bytes) {
    try {
        decode<T>(bytes);
    } catch (const ProtocolError& error) {
        return error.what();
    }
    return "taken";
}

template <class T>
T thereAndBack(const T& value) {
    return decode<T>(encode(value));
}

glm::mat4 countingMatrix() {
    glm::mat4 matrix(0.0f);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            matrix[column][row] = static_cast<float>(10 * column + row);
    return matrix;
}

TEST(Value, EveryTypeComesBackAsItWas) {
    EXPECT_TRUE(thereAndBack(true));
    EXPECT_FALSE(thereAndBack(false));
    EXPECT_EQ(thereAndBack(std::numeric_limits<int>::min()), std::numeric_limits<int>::min());
    EXPECT_EQ(thereAndBack(0.1f), 0.1f);
    EXPECT_EQ(thereAndBack(glm::vec2(1, -2)), glm::vec2(1, -2));
    EXPECT_EQ(thereAndBack(glm::vec3(1, -2, 3)), glm::vec3(1, -2, 3));
    EXPECT_EQ(thereAndBack(glm::vec4(1, -2, 3, 4)), glm::vec4(1, -2, 3, 4));
    EXPECT_EQ(thereAndBack(glm::mat3(countingMatrix())), glm::mat3(countingMatrix()));
    EXPECT_EQ(thereAndBack(countingMatrix()), countingMatrix());
}

TEST(Value, FloatsThatAreNoNumbersComeBackToo) {
    EXPECT_TRUE(std::isnan(thereAndBack(std::numeric_limits<float>::quiet_NaN())));
    EXPECT_EQ(thereAndBack(-std::numeric_limits<float>::infinity()),
              -std::numeric_limits<float>::infinity());
}

TEST(Value, MatricesTravelByColumns) {
    const Bytes bytes = encode(glm::mat3(countingMatrix()));
    float second;
    std::memcpy(&second, bytes.data() + 1 + sizeof(float), sizeof second);
    EXPECT_EQ(second, 1.0f) << "column 0, row 1 follows column 0, row 0";
}

TEST(Value, VectorsAndTuplesKeepTheirOrder) {
    using Points = std::vector<glm::vec3>;
    EXPECT_THAT(thereAndBack(Points{{1, 2, 3}, {4, 5, 6}}),
                ElementsAre(glm::vec3(1, 2, 3), glm::vec3(4, 5, 6)));
    EXPECT_TRUE(thereAndBack(Points{}).empty());
    EXPECT_THAT(thereAndBack(std::vector<bool>{true, false}), ElementsAre(true, false));
    using Mixed = std::tuple<int, int, glm::vec2, Points, bool>;
    const Mixed mixed{1, 2, {3, 4}, {{5, 6, 7}}, true};
    EXPECT_EQ(thereAndBack(mixed), mixed);
}

TEST(Value, ArgumentsAreReadOneAfterTheOther) {
    const Bytes bytes = encode(90.0f, glm::vec3(0, 1, 0));
    protocol::ByteReader in(bytes);
    EXPECT_EQ(protocol::Codec<float>::read(in), 90.0f);
    EXPECT_EQ(protocol::Codec<glm::vec3>::read(in), glm::vec3(0, 1, 0));
    EXPECT_NO_THROW(in.end());
}

TEST(Value, AnotherTypeIsToldApart) {
    EXPECT_THAT(refusal<glm::mat3>(encode(glm::vec3(1))), HasSubstr("expected mat3"));
    EXPECT_THAT(refusal<float>(encode(1)), HasSubstr("expected float"));
    EXPECT_THAT(refusal<std::vector<float>>(encode(1.0f)), HasSubstr("vector of float"));
    EXPECT_THAT(refusal<std::vector<float>>(encode(std::vector<int>{1})), HasSubstr("vector of"));
    EXPECT_THAT((refusal<std::tuple<int, int>>(encode(1))), HasSubstr("tuple of 2"));
    EXPECT_THAT((refusal<std::tuple<int, int>>(encode(std::tuple<int>{1}))),
                HasSubstr("tuple of 2"));
    EXPECT_THAT((refusal<std::tuple<int, float>>(encode(std::tuple<float, int>{1.0f, 1}))),
                HasSubstr("expected int"));
}

TEST(Value, EveryTruncationIsNoticed) {
    using Mixed = std::tuple<glm::mat4, std::vector<float>, bool>;
    const Bytes whole = encode(Mixed{countingMatrix(), {1, 2}, true});
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_THROW(decode<Mixed>(std::span(whole).first(size)), ProtocolError) << size;
}

TEST(Value, BytesThatFollowAreNoticed) {
    Bytes bytes = encode(glm::vec2(1, 2));
    bytes.push_back(0);
    EXPECT_EQ(refusal<glm::vec2>(bytes), "1 bytes too many");
}

TEST(Value, ALieAboutAVectorsLengthTakesNoMemory) {
    Bytes bytes = encode(std::vector<float>{1, 2});
    const std::uint32_t lie = 0xfffffff0;
    std::memcpy(bytes.data() + 1, &lie, sizeof lie);
    EXPECT_THAT(refusal<std::vector<float>>(bytes), HasSubstr("longer than its message"));
    const std::uint32_t smallLie = 3;
    std::memcpy(bytes.data() + 1, &smallLie, sizeof smallLie);
    EXPECT_THAT(refusal<std::vector<float>>(bytes), HasSubstr("longer than its message"));
}

}  // namespace
